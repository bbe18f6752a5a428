#include "scenes/spectra/tabulated_spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace plumb {

namespace {

/// CIE 1931 colour matching functions as sums of two-sided Gaussians [Wyman, Sloan & Shirley 2013, eq. 4].
std::array<double, 3> matching_functions(double nm) {
    const auto g = [nm](double mean, double below, double above) {
        const double t = (nm - mean) / (nm < mean ? below : above);
        return std::exp(-0.5 * t * t);
    };
    return {1.056 * g(599.8, 37.9, 31.0) + 0.362 * g(442.0, 16.0, 26.7) - 0.065 * g(501.1, 20.4, 26.2),
            0.821 * g(568.8, 46.9, 40.5) + 0.286 * g(530.9, 16.3, 31.1),
            1.217 * g(437.0, 11.8, 36.0) + 0.681 * g(459.0, 26.0, 13.8)};
}

/// CIE standard illuminant D65, relative power from 380 to 780 nm by 10 nm [CIE 15].
constexpr std::array<double, 41> d65{49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865, 117.008, 117.812,
                                     114.861, 115.923, 108.811, 109.354, 107.802, 104.790, 107.689, 104.405, 104.046,
                                     100.000, 96.3342, 95.7880, 88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992,
                                     80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.3490, 61.6040, 69.8856,
                                     75.0870, 63.5927, 46.4182, 66.8054, 63.3828};

double d65_at(double nm) {
    const double x = std::clamp((nm - 380) / 10, 0.0, 40.0);
    const auto i = std::min<std::size_t>(39, static_cast<std::size_t>(x));
    const double t = x - static_cast<double>(i);
    return d65[i] * (1 - t) + d65[i + 1] * t;
}

double value_at(const TabulatedSpectrum& spectrum, double nm) {
    const auto above = std::ranges::lower_bound(spectrum, nm, {}, &std::pair<double, double>::first);
    if (above == spectrum.end()) return 0;
    if (above->first == nm) return above->second;
    if (above == spectrum.begin()) return 0;
    const auto below = above - 1;
    const double t = (nm - below->first) / (above->first - below->first);
    return below->second * (1 - t) + above->second * t;
}

Spectrum srgb_from_xyz(const std::array<double, 3>& xyz) {
    const auto [x, y, z] = xyz;  // [IEC 61966-2-1]
    return Spectrum::rgb(3.2404542 * x - 1.5371385 * y - 0.4985314 * z, -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
                         0.0556434 * x - 0.2040259 * y + 1.0572252 * z);
}

/// Linear sRGB of a power distribution, by the trapezoidal rule of 1 nm over the visible, and the integral of y-bar.
Spectrum integrated_rgb(const std::function<double(double)>& power) {
    std::array<double, 3> xyz{};
    for (int nm = 380; nm <= 780; ++nm) {
        const double p = power(nm) * (nm == 380 || nm == 780 ? 0.5 : 1);
        const auto bars = matching_functions(nm);
        for (std::size_t i = 0; i < 3; ++i) xyz[i] += p * bars[i];
    }
    return srgb_from_xyz(xyz);
}

}  // namespace

Spectrum reflectance_rgb(const TabulatedSpectrum& spectrum) {
    static const Spectrum white = integrated_rgb(d65_at);
    Spectrum rgb = integrated_rgb([&](double nm) { return d65_at(nm) * value_at(spectrum, nm); });
    for (std::size_t i = 0; i < 3; ++i) rgb[i] = std::clamp(rgb[i] / white[i], 0.0, 1.0);
    return rgb;
}

Spectrum emission_rgb(const TabulatedSpectrum& spectrum) {
    static const double unit = luminance(integrated_rgb([](double) { return 1.0; }));
    Spectrum rgb = integrated_rgb([&](double nm) { return value_at(spectrum, nm); }) / unit;
    for (std::size_t i = 0; i < 3; ++i) rgb[i] = std::max(0.0, rgb[i]);
    return rgb;
}

}  // namespace plumb
