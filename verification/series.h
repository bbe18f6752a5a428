#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/interval.h"

namespace plumb {

/// The error of an estimator at one sample count, over independent replicates.
struct ConvergencePoint {
    std::uint64_t n = 0;      ///< samples asked for
    double evaluations = 0;   ///< mean calls of the integrand per replicate
    double seconds = 0;       ///< mean per replicate; a side record, never part of a verdict
    double mse = 0;           ///< about the known value
    Interval mse_interval{};  ///< 95 %
    double bias = 0, bias_standard_error = 0;
    double log_mse_error = 0;                           ///< standard error of log(mse), NaN where mse is not positive
    double log_mse_skewness = 0, log_mse_kurtosis = 0;  ///< as of a LogMean; 0 where they are not known
};

/// The slope of log MSE on log n, with its error.
struct Slope {
    double value = std::numeric_limits<double>::quiet_NaN();
    double standard_error = std::numeric_limits<double>::quiet_NaN();
    Interval interval{};  ///< 95 %; unbounded where the points leave none
    /// Why the interval is missing or a slope says little: heavy tails, no power law. A sentence, or empty.
    std::string doubt = {};
};

/// Error against work for one estimator on one integrand, with the slope of log MSE on log n.
struct Series {
    std::string estimator, integrand;
    std::uint64_t replicates = 0;
    std::vector<ConvergencePoint> points;
    Slope slope;
    std::optional<Interval> expected_slope;  ///< what theory says, where it says anything
};

/// The relative error of a formula in one of its hard cases, against the truth in many digits.
struct StabilityPoint {
    std::string hard_case;
    double x = 0;               ///< where on the corpus' axis (for the plot)
    double relative_error = 0;  ///< in units of ulp if unit says so
};
/// A formula's relative errors over its corpus of hard cases, against the bound that is claimed.
struct Stability {
    std::string formula, axis, unit = "ulp";
    double bound = 0;  ///< what is claimed
    std::vector<StabilityPoint> points;
};

}  // namespace plumb
