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

    friend constexpr Spectrum operator+(Spectrum a, const Spectrum& b) { return a += b; }
    friend constexpr Spectrum operator-(Spectrum a, const Spectrum& b) {
        for (std::size_t i = 0; i < 4; ++i) a.lane[i] -= b.lane[i];
        return a;
    }
    friend constexpr Spectrum operator*(Spectrum a, const Spectrum& b) { return a *= b; }
    friend constexpr Spectrum operator*(Spectrum a, double s) { return a *= s; }
    friend constexpr Spectrum operator*(double s, Spectrum a) { return a *= s; }
    friend constexpr Spectrum operator/(Spectrum a, double s) {
        for (double& value : a.lane) value /= s;
        return a;
    }
    constexpr Spectrum& operator+=(const Spectrum& b) {
        for (std::size_t i = 0; i < 4; ++i) lane[i] += b.lane[i];
        return *this;
    }
    constexpr Spectrum& operator*=(const Spectrum& b) {
        for (std::size_t i = 0; i < 4; ++i) lane[i] *= b.lane[i];
        return *this;
    }
    constexpr Spectrum& operator*=(double s) {
        for (double& value : lane) value *= s;
        return *this;
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
