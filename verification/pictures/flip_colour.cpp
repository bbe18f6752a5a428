#include "verification/pictures/flip_colour.h"

#include <cmath>

namespace plumb::flip {
namespace {

using Matrix = std::array<Triple, 3>;

constexpr double whole_x = 24577794, whole_y = 12288897, whole_z = 73733382;
/// XYZ of linear sRGB with white D65, in the digits that FLIP gives.
constexpr Matrix to_xyz{{{10135552 / whole_x, 8788810 / whole_x, 4435075 / whole_x},
                         {2613072 / whole_y, 8788810 / whole_y, 887015 / whole_y},
                         {1425312 / whole_z, 8788810 / whole_z, 70074185 / whole_z}}};
constexpr Triple white{to_xyz[0][0] + to_xyz[0][1] + to_xyz[0][2], to_xyz[1][0] + to_xyz[1][1] + to_xyz[1][2],
                       to_xyz[2][0] + to_xyz[2][1] + to_xyz[2][2]};

constexpr Matrix inverse(const Matrix& m) {
    const auto cofactor = [&](std::size_t i, std::size_t j) {
        const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
        return m[a][c] * m[b][d] - m[a][d] * m[b][c];
    };
    const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
    Matrix result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result[j][i] = cofactor(i, j) / determinant;
    return result;
}
constexpr Matrix from_xyz = inverse(to_xyz);

Triple times(const Matrix& m, const Triple& v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

/// XYZ over white's.
Triple relative_xyz(const Triple& rgb) {
    Triple xyz = times(to_xyz, rgb);
    for (std::size_t i = 0; i < 3; ++i) xyz[i] /= white[i];
    return xyz;
}

/// Of XYZ over white's, or of their cube roots.
Triple opponents(const Triple& v) {
    return {116 * v[1] - 16, 500 * (v[0] - v[1]), 200 * (v[1] - v[2])};
}

double root(double t) {
    constexpr double edge = 6.0 / 29;
    return t > edge * edge * edge ? std::cbrt(t) : t / (3 * edge * edge) + 4.0 / 29;
}

constexpr double exponent = 0.7;

double largest_error() {
    return std::pow(hyab(hunt_adjusted(lab_of({0, 1, 0})), hunt_adjusted(lab_of({0, 0, 1}))), exponent);
}

}  // namespace

Triple opponent_of(const Triple& rgb) {
    return opponents(relative_xyz(rgb));
}

Triple rgb_of(const Triple& opponent) {
    const double y = (opponent[0] + 16) / 116;
    return times(from_xyz, {white[0] * (y + opponent[1] / 500), white[1] * y, white[2] * (y - opponent[2] / 200)});
}

Triple rgb_of_xyz(const Triple& xyz) {
    return times(from_xyz, xyz);
}

Triple lab_of(const Triple& rgb) {
    const Triple xyz = relative_xyz(rgb);
    return opponents({root(xyz[0]), root(xyz[1]), root(xyz[2])});
}

Triple hunt_adjusted(const Triple& lab) {
    return {lab[0], 0.01 * lab[0] * lab[1], 0.01 * lab[0] * lab[2]};
}

double hyab(const Triple& one, const Triple& other) {
    return std::abs(one[0] - other[0]) + std::hypot(one[1] - other[1], one[2] - other[2]);
}

double colour_error(double distance) {
    constexpr double share = 0.4, end = 0.95;
    static const double largest = largest_error();
    const double part = std::pow(distance, exponent) / largest;
    return part < share ? end * part / share : end + (1 - end) * (part - share) / (1 - share);
}

}  // namespace plumb::flip
