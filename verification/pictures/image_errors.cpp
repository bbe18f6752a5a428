#include "verification/pictures/image_errors.h"

#include <algorithm>
#include <cmath>

#include "core/moments.h"
#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

/// The terms of one measure, one a pixel (the channels' mean).
struct Terms {
    Moments moments;
    double sum = 0;
    void end_pixel(double channels) {
        moments.add(sum / channels);
        sum = 0;
    }
    [[nodiscard]] Interval interval(double inflation) const {
        const double reach = normal_upper_quantile(0.025) * moments.standard_error() * std::sqrt(inflation);
        return {moments.mean() - reach, moments.mean() + reach};
    }
};

double root(double x) {
    return x < 0 ? 0 : std::sqrt(x);
}

double mean_of_finite(const Picture& a, const Picture& b) {
    Moments moments;
    for (std::size_t k = 0; k < b.mean.size(); ++k)
        if (std::isfinite(a.mean[k]) && std::isfinite(b.mean[k])) moments.add(b.mean[k]);
    return moments.count() > 0 ? moments.mean() : 0;
}

}  // namespace

std::vector<ErrorMeasure> errors_of(const Picture& a, const Picture& b, double inflation) {
    const std::size_t count = a.channels.size();
    const double least = std::abs(mean_of_finite(a, b)) / 100;
    Terms square, percentage, relative, power;
    for (std::size_t p = 0; p < a.mean.size(); p += count) {
        if (!std::isfinite(a.mean[p]) || !std::isfinite(b.mean[p])) continue;
        for (std::size_t k = p; k < p + count; ++k) {
            const double d = a.mean[k] - b.mean[k], va = a.variance[k], vb = b.variance[k], r = b.mean[k];
            const double error = d * d - vb, scale = r * r + least * least;
            square.sum += error;
            power.sum += r * r - vb;
            relative.sum += scale > 0 ? error / scale : 0;
            const double own = va + vb > 0 ? std::sqrt(va / (va + vb)) : 1;
            percentage.sum += d == 0 ? 0 : std::abs(d) * own / (std::abs(r) + least);
        }
        for (Terms* terms : {&square, &percentage, &relative, &power}) terms->end_pixel(static_cast<double>(count));
    }
    if (square.moments.count() == 0) return {};
    const double mse = square.moments.mean(), energy = power.moments.mean();
    const Interval s = square.interval(inflation);
    return {{"RMSE", root(mse), {root(s.low), root(s.high)}},
            {"relMSE", mse / energy, {s.low / energy, s.high / energy}},
            {"MAPE", percentage.moments.mean(), percentage.interval(inflation)},
            {"MRSE", relative.moments.mean(), relative.interval(inflation)}};
}

}  // namespace plumb
