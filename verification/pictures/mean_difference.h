#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/interval.h"
#include "verification/pictures/picture.h"
#include "verification/pictures/pixel_grid.h"
#include "verification/pictures/sum_inflation.h"

namespace plumb {

/// The difference of two sums over the same pixels: of a tile or of the picture, in one channel.
struct MeanDifference {
    double a = 0, b = 0, difference = 0;  ///< mean a, mean b, a − b
    double standard_error = 0;
    double degrees = 0;   ///< of freedom of that, by Welch and Satterthwaite
    double skewness = 0;  ///< upper bound of the sums' own
    double z = 0;         ///< normal score of Student's t, signed
    /// By which factor samples must grow until an undecided difference is likely to be decided; NaN where it is
    /// decided, or nobody knows.
    double more_samples = std::numeric_limits<double>::quiet_NaN();
    double p_value = 1;   ///< two-sided, enlarged by what skewness can do
    double delta = 0;     ///< what `holds` excludes, absolute
    Interval interval{};  ///< of the difference; each end is wrong with probability beta
};

/// Sums over pixels that are finite in both pictures, in one channel.
struct DifferenceSums {
    std::uint64_t pixels = 0;
    double a = 0, b = 0;  ///< of values
    double rounding = 0;  ///< of what rounding may have moved them by
    double variance_a = 0, variance_b = 0;
    double shown_a = 0, shown_b = 0;              ///< the same, without what rounding may have hidden
    double square_a = 0, square_b = 0;            ///< of variance² / (degrees + 2): unbiased for 1/degrees of σ⁴
    double third_a = 0, third_b = 0;              ///< of third cumulants
    double third_error_a = 0, third_error_b = 0;  ///< variances of those

    void merge(const DifferenceSums& other);
};

/// The sums of a box. A mean and the variance estimated from the same n values have covariance κ₃/n, so that (a −
/// b)·variance_a estimates the third cumulant of a's mean without bias, whatever the distribution, where both have the
/// same expectation. A bias must not look like a third cumulant: the difference of the eight neighbours is taken off
/// first, and the rest is cut at two standard errors (a spike lies one away, whatever its size).
DifferenceSums sums_of(const Picture& a, const Picture& b, const PixelBox& box, std::size_t channel);

/// The rules by which a difference is judged.
struct DifferenceRules {
    double degrees_a = 0, degrees_b = 0;  ///< of one pixel's variances
    Inflation inflation = {};             ///< of the variances, by correlated neighbours
    double epsilon = 0;                   ///< absolute: a difference that is allowed, and refutes nothing
    double beta = 0.01;
    double delta = 0;  ///< absolute
    /// The amount that a rare path brings to a pixel's mean, as it shows elsewhere: pixels without variance, on either
    /// side, may lack some. 0: nothing shows noise anywhere.
    double spike = 0;
};

/// The largest standard error of a pixel's difference in one channel: as much as one path brought there, at least.
double largest_spike(const Picture& a, const Picture& b, std::size_t channel);

/// Tests equality and gives the interval of the difference. Sums without any variance are equal or not, except for
/// spikes that no sample met: with m of them expected, that has probability exp(−m) [Poisson]. `around` has the sums of
/// a larger region that contains the pixels; its skewness counts where it is more, for spikes that the region has and
/// these pixels happen to lack.
MeanDifference difference_of(const DifferenceSums& sums, const DifferenceSums& around, const DifferenceRules& rules);

/// Whether skewness allows intervals of this one-sided risk: skewness·z³/3 ≤ 1.
bool interval_is_trusted(const MeanDifference& found, double beta);

/// The normal score with the tail that Student's t has beyond t.
double normal_score_of_student(double t, double degrees_of_freedom);

/// A two-sided p-value at the normal score z for a sum of this skewness, as if its error came in n = 1/skewness² equal
/// spikes of Poisson's law, whose missing ones lessen the estimated variance too: Φ's tail times exp(z²/2 − rate), with
/// rate n·((1 − m) log(1 − m) + m) where z = m √n/√(1 − m). To third order that is Cramér's factor exp(skewness·z³/3);
/// it never falls below about exp(−n), the probability that all spikes are missing.
double skewed_p_value(double z, double skewness);

}  // namespace plumb
