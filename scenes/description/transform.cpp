#include "scenes/description/transform.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.h"

namespace plumb {

namespace {

Vec3 row(const Transform::Matrix& m, std::size_t i) {
    return {m[i][0], m[i][1], m[i][2]};
}

Transform::Matrix from_columns(Vec3 x, Vec3 y, Vec3 z, Vec3 offset) {
    return {{{x.x, y.x, z.x, offset.x}, {x.y, y.y, z.y, offset.y}, {x.z, y.z, z.z, offset.z}, {0, 0, 0, 1}}};
}

Transform::Matrix product(const Transform::Matrix& a, const Transform::Matrix& b) {
    Transform::Matrix c{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            for (std::size_t k = 0; k < 4; ++k) c[i][j] += a[i][k] * b[k][j];
        }
    }
    return c;
}

}  // namespace

Transform::Transform(const Matrix& matrix) : matrix_(matrix) {
    for (const auto& line : matrix) {
        for (const double entry : line) {
            if (!std::isfinite(entry))
                throw Error(fmt::format("transform with the entry {}; finite ones are accepted", entry));
        }
    }
    if (matrix[3] != std::array<double, 4>{0, 0, 0, 1}) {
        throw Error(fmt::format("transform with the last row {} {} {} {}; an affine one (0 0 0 1) is accepted",
                                matrix[3][0], matrix[3][1], matrix[3][2], matrix[3][3]));
    }
    const Vec3 a = row(matrix, 0), b = row(matrix, 1), c = row(matrix, 2);
    const double det = dot(a, cross(b, c));
    // Hadamard: |det| is at most the product of the rows' lengths; 2^-44 of it is what rounding can leave of zero.
    if (!(std::abs(det) > 0x1p-44 * length(a) * length(b) * length(c))) {
        throw Error(fmt::format("singular transform (determinant {:.3g}); an invertible one is accepted", det));
    }
    // The inverse's columns are cross products of the rows [Cramer].
    const Vec3 x = cross(b, c) / det, y = cross(c, a) / det, z = cross(a, b) / det;
    const Vec3 offset{matrix[0][3], matrix[1][3], matrix[2][3]};
    inverse_ = from_columns(x, y, z, -(x * offset.x + y * offset.y + z * offset.z));
}

Transform Transform::translate(Vec3 by) {
    return Transform(from_columns({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by));
}

Transform Transform::scale(Vec3 by) {
    return Transform(from_columns({by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}, {}));
}

Transform Transform::rotate(Vec3 axis, double degrees) {
    if (!(length_squared(axis) > 0)) throw Error("rotation about the axis 0 0 0; another axis is accepted");
    const Vec3 a = normalize(axis);
    const double angle = degrees * std::numbers::pi / 180, s = std::sin(angle), c = std::cos(angle);
    const auto turned = [&](Vec3 v) { return v * c + cross(a, v) * s + a * (dot(a, v) * (1 - c)); };  // [Rodrigues]
    return Transform(from_columns(turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}), {}));
}

Transform Transform::look_at(Vec3 origin, Vec3 target, Vec3 up) {
    const Vec3 to_target = target - origin;
    if (!(length_squared(to_target) > 0)) throw Error("lookat with its target at its origin");
    const Vec3 z = normalize(to_target), side = cross(up, z);
    if (!(length(side) > 1e-12 * length(up))) throw Error("lookat with up along the direction of view");
    const Vec3 x = normalize(side);
    return Transform(from_columns(x, cross(z, x), z, origin));
}

Vec3 Transform::normal(Vec3 n) const {
    return row(inverse_, 0) * n.x + row(inverse_, 1) * n.y + row(inverse_, 2) * n.z;
}

double Transform::determinant() const {
    return dot(row(matrix_, 0), cross(row(matrix_, 1), row(matrix_, 2)));
}

Transform operator*(const Transform& a, const Transform& b) {
    return {product(a.matrix_, b.matrix_), product(b.inverse_, a.inverse_)};
}

}  // namespace plumb
