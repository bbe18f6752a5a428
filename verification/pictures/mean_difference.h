#pragma once

#include <cstddef>
#include <cstdint>

#include "core/interval.h"
#include "verification/pictures/picture.h"

namespace plumb {

/// The difference of two sums over the same pixels: of a tile or of the picture, in one channel.
struct MeanDifference {
    double a = 0, b = 0, difference = 0;  ///< mean a, mean b, a − b
    double standard_error = 0;
    double degrees = 0;   ///< of freedom of that, by Welch and Satterthwaite
    double skewness = 0;  ///< upper bound of the sums' own
    double z = 0;         ///< normal score of Student's t, signed
    double p_value = 1;   ///< two-sided, enlarged by what skewness can do
    double delta = 0;     ///< what `holds` excludes, absolute
    Interval interval{};  ///< of the difference; each end is wrong with probability beta
};

/// A rectangle of pixels.
struct PixelBox {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Sums over pixels that are finite in both pictures, in one channel.
struct DifferenceSums {
    std::uint64_t pixels = 0;
    double a = 0, b = 0;  ///< of values
    double variance_a = 0, variance_b = 0;
    double square = 0;                ///< of variance² / (degrees + 2), both sides: unbiased for 1/degrees of σ⁴
    double third_a = 0, third_b = 0;  ///< of third cumulants
    double third_error = 0;           ///< variance of those

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
    double inflation = 1;                 ///< of the variance, by correlated neighbours
    double rounding = 0;                  ///< relative: differences that are none
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

/// A two-sided p-value at the normal score z for a sum of this skewness, as if its error came in n = 1/skewness² equal
/// spikes of Poisson's law, whose missing ones lessen the estimated variance too: Φ's tail times exp(z²/2 − rate), with
/// rate n·((1 − m) log(1 − m) + m) where z = m √n/√(1 − m). To third order that is Cramér's factor exp(skewness·z³/3);
/// it never falls below about exp(−n), the probability that all spikes are missing.
double skewed_p_value(double z, double skewness);

}  // namespace plumb
