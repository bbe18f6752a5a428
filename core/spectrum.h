#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace plumb {

/// Radiance, reflectance or throughput in four lanes: linear sRGB in the first three now (the fourth is zero), four
/// hero wavelengths later. Everything is lane by lane.
struct Spectrum {
    std::array<double, 4> lane{};

    static constexpr Spectrum rgb(double r, double g, double b) { return {{r, g, b, 0}}; }
    static constexpr Spectrum grey(double value) { return rgb(value, value, value); }

    constexpr double operator[](std::size_t i) const { return lane[i]; }
    constexpr double& operator[](std::size_t i) { return lane[i]; }

    // Lane by lane in writing too, because compilers do not unroll loops at -O2: each would take three times the
    // instructions.
    constexpr Spectrum& operator+=(const Spectrum& b) { return *this = *this + b; }
    constexpr Spectrum& operator*=(const Spectrum& b) { return *this = *this * b; }
    constexpr Spectrum& operator*=(double s) { return *this = *this * s; }
    friend constexpr Spectrum operator+(const Spectrum& a, const Spectrum& b) {
        return {{a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]}};
    }
    friend constexpr Spectrum operator-(const Spectrum& a, const Spectrum& b) {
        return {{a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]}};
    }
    friend constexpr Spectrum operator*(const Spectrum& a, const Spectrum& b) {
        return {{a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]}};
    }
    friend constexpr Spectrum operator*(const Spectrum& a, double s) {
        return {{a[0] * s, a[1] * s, a[2] * s, a[3] * s}};
    }
    friend constexpr Spectrum operator*(double s, const Spectrum& a) { return a * s; }
    friend constexpr Spectrum operator/(const Spectrum& a, double s) {
        return {{a[0] / s, a[1] / s, a[2] / s, a[3] / s}};
    }
    friend constexpr bool operator==(const Spectrum&, const Spectrum&) = default;
};

/// Rec. 709 luminance of linear sRGB.
constexpr double luminance(const Spectrum& s) {
    return 0.2126 * s[0] + 0.7152 * s[1] + 0.0722 * s[2];
}
constexpr double largest(const Spectrum& s) {
    return std::max({s[0], s[1], s[2], s[3]});
}
constexpr bool is_black(const Spectrum& s) {
    return ((s[0] == 0) & (s[1] == 0) & (s[2] == 0) & (s[3] == 0)) != 0;  // no branch that colours would mispredict
}
inline bool is_finite(const Spectrum& s) {
    return std::ranges::all_of(s.lane, [](double value) { return std::isfinite(value); });
}

}  // namespace plumb
