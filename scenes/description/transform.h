#pragma once

#include <array>

#include "core/vec3.h"

namespace plumb {

/// An invertible affine map with its inverse, in double. It applies to columns: (a * b) is b first, then a.
class Transform {
public:
    using Matrix = std::array<std::array<double, 4>, 4>;

    Transform() = default;
    /// The map of a matrix, rows from the top. Throws Error for a matrix with a non-finite entry, with a last row other
    /// than 0 0 0 1, or singular (a determinant within rounding of zero).
    explicit Transform(const Matrix& matrix);

    static Transform translate(Vec3 by);
    static Transform scale(Vec3 by);
    /// A rotation about the axis, in degrees, counterclockwise as seen against it; throws Error for a zero axis.
    static Transform rotate(Vec3 axis, double degrees);
    /// The map that takes +z to the direction towards the target and +y near up; throws Error where they are parallel
    /// or coincide.
    static Transform look_at(Vec3 origin, Vec3 target, Vec3 up);

    [[nodiscard]] Vec3 point(Vec3 p) const { return apply(matrix_, p, 1); }
    [[nodiscard]] Vec3 vector(Vec3 v) const { return apply(matrix_, v, 0); }
    /// The normal mapped by the transposed inverse, not of unit length.
    [[nodiscard]] Vec3 normal(Vec3 n) const;

    [[nodiscard]] Transform inverse() const { return Transform(inverse_, matrix_); }
    /// The determinant of the linear part: negative where handedness turns.
    [[nodiscard]] double determinant() const;
    [[nodiscard]] const Matrix& matrix() const { return matrix_; }

    friend Transform operator*(const Transform& a, const Transform& b);

private:
    Transform(const Matrix& matrix, const Matrix& inverse) : matrix_(matrix), inverse_(inverse) {}

    static Vec3 apply(const Matrix& m, Vec3 a, double w) {
        return {m[0][0] * a.x + m[0][1] * a.y + m[0][2] * a.z + m[0][3] * w,
                m[1][0] * a.x + m[1][1] * a.y + m[1][2] * a.z + m[1][3] * w,
                m[2][0] * a.x + m[2][1] * a.y + m[2][2] * a.z + m[2][3] * w};
    }

    static constexpr Matrix identity{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    Matrix matrix_ = identity, inverse_ = identity;
};

}  // namespace plumb
