#pragma once

#include <cstdint>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

#include "core/interval.h"
#include "core/random.h"
#include "estimators/estimator.h"
#include "verification/run.h"
#include "verification/verdict.h"

// The mean claims of 1D reweighting share what follows. They integrate e^x, which is not linear (the bias of clipped
// cells is 0 for lines) and not 0 at the ends.

namespace plumb::reweighting_1d {

using Samples = std::vector<double>;
using SampleSet = Samples (*)(std::uint64_t, RandomStream&);
using Weigh = std::function<Samples(std::span<const double>)>;
/// One independent estimate from n samples.
using Value = std::function<double(std::uint64_t n, RandomStream&)>;

constexpr double e = std::numbers::e;
constexpr double integral_of_exp = e - 1;
double exponential(const Point<1>& x);

/// The weighted sum Σ w_i f(x_i).
Value weighted(SampleSet draw, Weigh weigh, Function<1> f = exponential);

/// A number of samples N and how sharply to look there: δ is relative to the integral.
struct At {
    std::uint64_t n;
    double delta;
};

/// The verdict on whether the mean at each of these N is the stated one. The bounds are those of one value, ε is
/// absolute.
Verdict means_are(const Value& value, const std::function<double(std::uint64_t)>& truth, const std::vector<At>& places,
                  const Interval& bounds, const Run& run, double epsilon = 1e-12);

/// The verdict on whether that mean is ∫ e^x.
Verdict unbiased(const Value& value, const std::vector<At>& places, const Interval& bounds, const Run& run,
                 double epsilon = 1e-12);

}  // namespace plumb::reweighting_1d
