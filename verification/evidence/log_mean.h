#pragma once

#include <span>

#include "core/moments.h"

namespace plumb {

/// The logarithm of a mean of independent positive values (squared errors), and how far from normal it is.
/// docs/statistics.md, "Rates and ratios".
struct LogMean {
    double value = 0;
    double standard_error = 0;  ///< by the delta method: the values' coefficient of variation over √n
    double skewness = 0;  ///< s: of the logarithm over its own standard error, P(beyond z) is e^(∓s z³) times normal
    double kurtosis = 0;  ///< k: and another e^(k z⁴)

    /// |ln| of that factor at z, or more.
    [[nodiscard]] double distortion(double z) const;
    /// How many standard errors out this logarithm's tail is what a normal one's is at z; infinite where the distortion
    /// exceeds 4, beyond what expansions tell.
    [[nodiscard]] double quantile(double z) const;
};

/// Of as many values as the moments have.
LogMean log_mean(const Moments& values);

/// Σ weight · logarithm of independent ones.
LogMean combination(std::span<const LogMean> logs, std::span<const double> weights);

/// log a − log b, independent.
LogMean log_ratio(const LogMean& a, const LogMean& b);

/// Beyond this error of a logarithm nothing is decided.
inline constexpr double largest_log_error = 0.25;
/// `refuted` needs a distortion of at most this at its own quantile, as mean claims do …
inline constexpr double refutable_distortion = 1;
/// … and `holds`, and an interval that is shown: a risk of 1 % is then at most 1.3 %.
inline constexpr double interval_distortion = 0.25;

}  // namespace plumb
