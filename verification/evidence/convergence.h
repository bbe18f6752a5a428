#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/estimate.h"
#include "core/random.h"
#include "verification/evidence/log_mean.h"
#include "verification/run.h"
#include "verification/series.h"

namespace plumb {

/// One independent run of an estimator with n samples.
using Replicate = std::function<Estimate(std::uint64_t n, RandomStream&)>;

/// The setting of a measurement of error against n.
struct ConvergenceSetting {
    std::string estimator, integrand;  ///< names for the series
    double truth = 0;                  ///< the known integral: the MSE is about it and divides by R
    std::vector<std::uint64_t> n;      ///< sample counts, at least two for a slope
    std::uint64_t replicates = 1000;   ///< the same at every n; independent streams per n
};

/// Measures MSE, bias, evaluations and seconds at each n, and the slope of log MSE on log n by least squares weighted
/// with the errors that the replicates give (not the residuals).
Series measure_convergence(const Replicate& replicate, const ConvergenceSetting& setting, const Run& run);

/// The error of independent runs with n samples about the truth; the same bits however they were computed.
ConvergencePoint convergence_point(std::uint64_t n, std::span<const Estimate> replicates, double truth);

/// Sets the MSE and what follows from its standard error: a 95 % interval, and the error of log MSE where that exists.
void set_mse(ConvergencePoint& point, double mse, double standard_error);

/// Subtracts from a point's MSE what the error e of the truth adds, whose variance v lies within the interval: the MSE
/// about a wrong truth is larger by e² − 2e·bias, whose mean is v and whose variance, for normal e, is 2v² + 4v·bias².
void subtract_variance_of_truth(ConvergencePoint& point, const Interval& variance);

/// What of a point's log MSE a test needs.
LogMean log_mse_of(const ConvergencePoint& point);

/// Two sample counts between which the MSE falls otherwise than with an exponent of the interval.
struct Misfit {
    std::uint64_t n_first = 0, n_last = 0;
    double exponent = 0;  ///< between the two
    double excess = 0;    ///< by how much the drop of log MSE leaves what the interval allows
    LogMean drop;
};
/// All pairs of points whose MSEs have errors, the worst in units of its error first.
std::vector<Misfit> misfits(const std::vector<ConvergencePoint>& points, const Interval& exponents);

/// The same slope as fit_slope's, with all that a test needs of it; NaN without two points.
LogMean fitted_exponent(const std::vector<ConvergencePoint>& points);

/// The weighted least-squares slope over the points with mse > 0; level is two-sided (0.95 for a 95 % interval). No
/// interval and a doubt where a point's error is not known, exceeds 25 %, or is far from normal; a doubt where pairs
/// of points leave slope ± 1/4 at a level of 1 %.
Slope fit_slope(const std::vector<ConvergencePoint>& points, double level);

}  // namespace plumb
