#include "verification/suites/calibration/laws.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace plumb::suites {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double standard_normal(RandomStream& random) {
    const double r = std::sqrt(-2 * std::log1p(-random.uniform()));
    return r * std::cos(2 * std::numbers::pi * random.uniform());
}

// The probability p moved by theta standard deviations of a Bernoulli value, kept away from 0 and 1.
double moved(double p, double theta) {
    return std::clamp(p + theta * std::sqrt(p * (1 - p)), p / 16, 1 - (1 - p) / 16);
}

Tilt bernoulli_tilt(double p, double theta) {
    const double q = moved(p, theta), b = std::log1p(-p) - std::log1p(-q);
    return {std::log(p / q) - b, b};
}

Tilt normal_tilt(double theta) {
    return {-theta, theta * theta / 2};
}

}  // namespace

TiltedLaw TiltedLaw::at(double another_delta_over_sigma) const {
    TiltedLaw law = *this;
    law.delta_over_sigma = another_delta_over_sigma;
    return law;
}

TiltedLaw TiltedLaw::without_bounds(double smaller_delta_over_sigma, std::uint64_t least_samples) const {
    TiltedLaw law = at(smaller_delta_over_sigma);
    law.bounds = {};
    law.min_samples = least_samples;
    return law;
}

MeanTest TiltedLaw::test(double reference) const {
    return MeanTest({{reference, reference},
                     {reference - delta(), reference + delta()},
                     delta(),
                     bounds,
                     alpha_in_use,
                     beta_in_use,
                     min_samples});
}

TiltedLaw bernoulli(double p) {
    const auto draw = [=](double theta, RandomStream& random) {
        const double x = random.uniform() < moved(p, theta) ? 1 : 0;
        return TiltedValue{x, x};
    };
    return {fmt::format("Bernoulli({:g})", p),
            p,
            std::sqrt(p * (1 - p)),
            {0, 1},
            [=](double theta) { return bernoulli_tilt(p, theta); },
            draw};
}

TiltedLaw normal() {
    const auto draw = [](double theta, RandomStream& random) {
        const double x = theta + standard_normal(random);
        return TiltedValue{x, x};
    };
    return {"normal", 0, 1, {}, normal_tilt, draw};
}

TiltedLaw exponential() {  // of mean 1 + theta
    const auto draw = [](double theta, RandomStream& random) {
        const double x = -std::log1p(-random.uniform()) * (1 + theta);
        return TiltedValue{x, x};
    };
    const auto tilt = [](double theta) { return Tilt{1 / (1 + theta) - 1, std::log1p(theta)}; };
    return {"exponential", 1, 1, {0, infinity}, tilt, draw};
}

TiltedLaw lognormal(double s) {
    const auto draw = [=](double theta, RandomStream& random) {
        const double z = theta + standard_normal(random);
        return TiltedValue{std::exp(s * z), z};
    };
    const double mean = std::exp(s * s / 2);
    return {
        fmt::format("lognormal({:g})", s), mean, mean * std::sqrt(std::expm1(s * s)), {0, infinity}, normal_tilt, draw};
}

TiltedLaw spikes() {
    constexpr double p = 0.02, mean_spike = 6, mean_square = 112.0 / 3;  // of 4 (1 + u)
    const auto draw = [](double theta, RandomStream& random) {
        const bool spike = random.uniform() < moved(p, theta);
        const double x = random.uniform() + (spike ? 4 * (1 + random.uniform()) : 0);
        return TiltedValue{x, spike ? 1.0 : 0.0};
    };
    const double variance = 1.0 / 12 + p * mean_square - p * p * mean_spike * mean_spike;
    return {"spiking",
            0.5 + p * mean_spike,
            std::sqrt(variance),
            {0, 9},
            [](double theta) { return bernoulli_tilt(p, theta); },
            draw};
}

}  // namespace plumb::suites
