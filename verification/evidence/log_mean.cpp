#include "verification/evidence/log_mean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plumb {

double LogMean::distortion(double z) const {
    return std::abs(skewness) * std::pow(z, 3) + kurtosis * std::pow(z, 4);
}

double LogMean::quantile(double z) const {
    constexpr double most = 4;  // beyond which expansions tell nothing
    double moved = z;
    for (int i = 0; i < 50; ++i) {
        const double off = distortion(moved), next = std::sqrt(z * z + 2 * off);
        if (!(off <= most)) return std::numeric_limits<double>::infinity();
        if (next - moved <= 1e-6 * z) return next;
        moved = next;
    }
    return std::numeric_limits<double>::infinity();
}

// With u = mean/truth − 1, t the studentised mean and c the coefficient of variation, ln(1 + u) over its standard error
// c/((1 + u)√n) is t (1 + u/2) = t + t² c/(2√n). A tail of t at z is e^(∓γ z³/(3√n)) times the normal one, γ the
// skewness of a value [Hall 1992, section 2.6], and moving z by z² c/(2√n) takes e^(z³ c/(2√n)) off. The next order is
// that of the kurtosis, κ z⁴/(24 n) [Petrov 1975, VIII.2].
LogMean log_mean(const Moments& values) {
    const double n = static_cast<double>(values.count()), root = std::sqrt(n);
    const double variation = std::sqrt(values.variance()) / values.mean();
    return {.value = std::log(values.mean()),
            .standard_error = variation / root,
            .skewness = (values.skewness() / 3 - variation / 2) / root,
            .kurtosis = std::max(values.kurtosis() - 3, 0.0) / (24 * n)};
}

// Third and fourth cumulants add with the cubes and fourth powers of what each part contributes to the error.
LogMean combination(std::span<const LogMean> logs, std::span<const double> weights) {
    LogMean sum;
    double variance = 0, third = 0, fourth = 0;
    for (std::size_t i = 0; i < logs.size(); ++i) {
        const double error = weights[i] * logs[i].standard_error;
        sum.value += weights[i] * logs[i].value;
        variance += error * error;
        third += logs[i].skewness * error * error * error;
        fourth += logs[i].kurtosis * error * error * error * error;
    }
    sum.standard_error = std::sqrt(variance);
    sum.skewness = third / (variance * sum.standard_error);
    sum.kurtosis = fourth / (variance * variance);
    return sum;
}

LogMean log_ratio(const LogMean& a, const LogMean& b) {
    return combination(std::array{a, b}, std::array{1.0, -1.0});
}

}  // namespace plumb
