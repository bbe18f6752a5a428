#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace plumb {

/// A point, direction or normal in three dimensions; which one, and in which frame, the name says.
struct Vec3 {
    double x = 0, y = 0, z = 0;

    constexpr double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr double& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }

    friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
    friend constexpr Vec3 operator*(double s, Vec3 a) { return a * s; }
    friend constexpr Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }
    constexpr Vec3& operator+=(Vec3 b) { return *this = *this + b; }
    friend constexpr bool operator==(Vec3, Vec3) = default;
};

constexpr double dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double length_squared(Vec3 a) {
    return dot(a, a);
}
inline double length(Vec3 a) {
    return std::sqrt(length_squared(a));
}
/// The unit vector along a; a must not be zero.
inline Vec3 normalize(Vec3 a) {
    return a / length(a);
}

/// Right-handed orthonormal axes with z along a surface normal.
struct Frame {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

    Frame() = default;
    Frame(Vec3 x_axis, Vec3 y_axis, Vec3 z_axis) : x(x_axis), y(y_axis), z(z_axis) {}
    /// Any such axes for a unit normal, continuous but for z = −1 … [Duff et al. 2017].
    explicit Frame(Vec3 normal) : z(normal) {
        const double sign = std::copysign(1.0, z.z), a = -1 / (sign + z.z), b = z.x * z.y * a;
        x = {1 + sign * z.x * z.x * a, sign * b, -sign * z.x};
        y = {b, sign + z.y * z.y * a, -z.y};
    }

    [[nodiscard]] Vec3 to_local(Vec3 world) const { return {dot(world, x), dot(world, y), dot(world, z)}; }
    [[nodiscard]] Vec3 to_world(Vec3 local) const { return x * local.x + y * local.y + z * local.z; }
};

}  // namespace plumb
