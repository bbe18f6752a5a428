#include "verification/pictures/flip.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/moments.h"
#include "core/parallel.h"
#include "verification/pictures/flip_filters.h"

namespace plumb {
namespace flip {
namespace {

/// Calls body(k) for each pixel.
template <class Body>
void for_each_pixel(std::size_t pixels, Body body) {
    constexpr std::size_t batch = 4096;
    for_batches((pixels + batch - 1) / batch, [&](std::size_t i) {
        for (std::size_t k = i * batch; k < std::min(pixels, (i + 1) * batch); ++k) body(k);
    });
}

/// What the eye makes of a picture.
struct Seen {
    std::vector<Triple> colours;  ///< Hunt-adjusted L*a*b* of what it resolves
    std::vector<double> edges, points;
};

/// The length of a filter's answers along both axes.
std::vector<double> features(const Plane& smooth_x, const Plane& smooth_y, const Weights& weights) {
    std::vector<double> lengths = along_x(smooth_y, weights).values;
    const Plane down = along_y(smooth_x, weights);
    for (std::size_t k = 0; k < lengths.size(); ++k) lengths[k] = std::hypot(lengths[k], down.values[k]);
    return lengths;
}

Plane blurred(const Plane& plane, int number) {
    Plane sum{plane.width, plane.height, std::vector<double>(plane.values.size())};
    for (const Blur& blur : contrast_sensitivity(number, pixels_per_degree)) {
        const Plane part = along_y(along_x(plane, blur.weights), blur.weights);
        for (std::size_t k = 0; k < sum.values.size(); ++k) sum.values[k] += blur.share * part.values[k];
    }
    return sum;
}

Seen seen(const Shown& shown) {
    const std::size_t pixels = shown.rgb.size();
    std::array<Plane, 3> opponents;
    for (Plane& plane : opponents) plane = {shown.width, shown.height, std::vector<double>(pixels)};
    Plane light = opponents[0];
    for_each_pixel(pixels, [&](std::size_t k) {
        const Triple colour = opponent_of(shown.rgb[k]);
        for (std::size_t c = 0; c < 3; ++c) opponents[c].values[k] = colour[c];
        light.values[k] = (colour[0] + 16) / 116;
    });
    for (int c = 0; c < 3; ++c) {
        Plane& plane = opponents[static_cast<std::size_t>(c)];
        plane = blurred(plane, c);
    }
    Seen result{std::vector<Triple>(pixels), {}, {}};
    for_each_pixel(pixels, [&](std::size_t k) {
        Triple rgb = rgb_of({opponents[0].values[k], opponents[1].values[k], opponents[2].values[k]});
        for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
        result.colours[k] = hunt_adjusted(lab_of(rgb));
    });
    const FeatureFilters filters = feature_filters(pixels_per_degree);
    const Plane smooth_x = along_x(light, filters.smooth), smooth_y = along_y(light, filters.smooth);
    result.edges = features(smooth_x, smooth_y, filters.edge);
    result.points = features(smooth_x, smooth_y, filters.point);
    return result;
}

/// A rational function (k₀x² + k₁x)/(k₃x² + k₄x + k₅), as [Andersson et al. 2021] number its coefficients.
namespace aces {
constexpr double k0 = 0.36 * 2.51, k1 = 0.6 * 0.03, k3 = 0.36 * 2.43, k4 = 0.6 * 0.59, k5 = 0.14;
}

/// Where the curve of ACES has this value.
double exposed_to(double value) {
    using namespace aces;
    const double half = (k1 - k4 * value) / (k0 - k3 * value) / 2, product = -k5 * value / (k0 - k3 * value);
    return -half + std::sqrt(half * half - product);
}

double luminance(const Triple& rgb) {
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

double median(std::vector<double> values) {
    const auto half = static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, values.begin() + half);
    const double upper = values[static_cast<std::size_t>(half)];
    return values.size() % 2 == 1 ? upper : (upper + *std::max_element(values.begin(), values.begin() + half)) / 2;
}

Shown shown(const Picture& picture, const std::vector<Triple>& light, const auto& curve) {
    Shown result{picture.width, picture.height, light};
    for_each_pixel(light.size(), [&](std::size_t k) {
        for (double& v : result.rgb[k]) v = curve(v);
    });
    return result;
}

}  // namespace

std::vector<double> errors_of(const Shown& reference, const Shown& test) {
    const Seen a = seen(reference), b = seen(test);
    std::vector<double> errors(reference.rgb.size());
    for_each_pixel(errors.size(), [&](std::size_t k) {
        const double feature = std::max(std::abs(a.edges[k] - b.edges[k]), std::abs(a.points[k] - b.points[k]));
        errors[k] =
            std::pow(colour_error(hyab(a.colours[k], b.colours[k])), 1 - std::sqrt(feature / std::numbers::sqrt2));
    });
    return errors;
}

double tone_mapped(double x) {
    using namespace aces;
    x = std::min(x, 1e9);  // where the curve has long been cut off
    return std::clamp((k0 * x * x + k1 * x) / (k3 * x * x + k4 * x + k5), 0.0, 1.0);
}

std::vector<double> exposures_of(const std::vector<Triple>& reference) {
    constexpr double value = 0.85;
    std::vector<double> all, lit;
    for (const Triple& rgb : reference) {
        all.push_back(luminance(rgb));
        if (all.back() > 0) lit.push_back(all.back());
    }
    if (lit.empty()) return {0, 0};
    const double middle = median(all), low = middle > 0 ? middle : median(lit), at = exposed_to(value);
    const double start = std::log2(at / std::ranges::max(all)), stop = std::log2(at / low);
    const int count = std::max(2, static_cast<int>(std::ceil(stop - start)));
    std::vector<double> exposures;
    for (int i = 0; i < count; ++i) exposures.push_back(start + i * (stop - start) / (count - 1));
    return exposures;
}

}  // namespace flip

namespace {

using flip::Triple;

/// Linear sRGB of a picture's colours, grey where it has but Y; 0 where one of both is not finite or below 0.
std::vector<Triple> light_of(const Picture& picture, const Picture& other) {
    std::vector<Triple> light;
    const std::size_t count = picture.channels.size();
    for (std::size_t p = 0; p < picture.mean.size(); p += count) {
        Triple colour{};
        const bool good = std::isfinite(picture.mean[p]) && std::isfinite(other.mean[p]);
        for (std::size_t c = 0; good && c < 3; ++c) colour[c] = picture.mean[p + (count == 3 ? c : 0)];
        if (picture.channels[0] == "X") colour = flip::rgb_of_xyz(colour);
        for (double& v : colour) v = std::max(0.0, v);
        light.push_back(colour);
    }
    return light;
}

double mean_of(const std::vector<double>& errors, const Picture& a, const Picture& b) {
    Moments mean;
    const std::size_t count = a.channels.size();
    for (std::size_t k = 0; k < errors.size(); ++k)
        if (std::isfinite(a.mean[k * count]) && std::isfinite(b.mean[k * count])) mean.add(errors[k]);
    return mean.count() > 0 ? mean.mean() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::vector<ErrorMeasure> flip_errors_of(const Picture& a, const Picture& b) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Triple> light_a = light_of(a, b), light_b = light_of(b, a);
    const auto errors = [&](const auto& curve) {
        return flip::errors_of(flip::shown(b, light_b, curve), flip::shown(a, light_a, curve));
    };
    const std::vector<double> low = errors([](double v) { return std::min(1.0, v); });
    std::vector<double> high(low.size());
    for (const double exposure : flip::exposures_of(light_b)) {
        const double gain = std::exp2(exposure);
        const std::vector<double> at = errors([&](double v) { return flip::tone_mapped(gain * v); });
        for (std::size_t k = 0; k < high.size(); ++k) high[k] = std::max(high[k], at[k]);
    }
    return {{"FLIP", mean_of(low, a, b), {unknown, unknown}}, {"HDR-FLIP", mean_of(high, a, b), {unknown, unknown}}};
}

}  // namespace plumb
