#include "verification/pictures/mean_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

constexpr double largest_score = 37;  // beyond that the normal tail is no double

bool good(const Picture& a, const Picture& b, std::size_t k) {
    return std::isfinite(a.mean[k]) && std::isfinite(b.mean[k]);
}

// The mean difference of the up to eight neighbours; 0 where none is finite.
double around(const Picture& a, const Picture& b, int x, int y, std::size_t channel) {
    double sum = 0;
    int count = 0;
    for (int v = std::max(0, y - 1); v <= std::min(a.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(a.width - 1, x + 1); ++u) {
            const std::size_t k = a.at(u, v, channel);
            if ((u == x && v == y) || !good(a, b, k)) continue;
            sum += a.mean[k] - b.mean[k];
            ++count;
        }
    return count > 0 ? sum / count : 0;
}

double finite_part(double variance, double degrees) {
    return std::isinf(degrees) ? 0 : variance * variance / (degrees + 2);
}

// The standard normal quantile of a tail, and of the tail of Student's t; tails below 1e-300 are all alike.
double score_of_tail(double tail) {
    return tail >= 0.5 ? 0 : normal_upper_quantile(std::max(tail, 1e-300));
}

double variance_of(const DifferenceSums& sums, const Inflation& inflation) {
    return sums.variance_a * inflation.a + sums.variance_b * inflation.b;
}

// The skewness of the larger of both sides' sums, with a number of standard errors upon it. What k pixels share has k
// times the variance of their sum, and k² times its third cumulant; what cancels between pixels need not cancel there.
double skewness_of(const DifferenceSums& sums, double errors, const Inflation& inflation) {
    const auto third_of = [&](double third, double error, double factor) {
        return std::pow(std::max(1.0, factor), 2) * (std::abs(third) + errors * std::sqrt(error));
    };
    const double third = std::max(third_of(sums.third_a, sums.third_error_a, inflation.a),
                                  third_of(sums.third_b, sums.third_error_b, inflation.b));
    const double variance = variance_of(sums, inflation);
    return variance > 0 ? third / std::pow(variance, 1.5) : 0;
}

// [Satterthwaite 1946], with E v² = σ⁴ (1 + 2/ν) taken into account: exact for a single variance. Correlated pixels
// have correlated variances, and the inflations are estimates of their own.
double degrees_of(const DifferenceSums& sums, const Inflation& inflation) {
    const auto part = [](double variance, double squares, double factor, double degrees) {
        const double whole = factor * variance;
        return factor * factor * std::max(1.0, factor) * squares + finite_part(whole, degrees);
    };
    const double squares = part(sums.variance_a, sums.square_a, inflation.a, inflation.degrees_a) +
                           part(sums.variance_b, sums.square_b, inflation.b, inflation.degrees_b);
    if (!(squares > 0)) return std::numeric_limits<double>::infinity();
    const double variance = variance_of(sums, inflation);
    return std::max(1.0, variance * variance / squares - 2);
}

}  // namespace

void DifferenceSums::merge(const DifferenceSums& other) {
    pixels += other.pixels;
    a += other.a;
    b += other.b;
    rounding += other.rounding;
    shown_a += other.shown_a;
    shown_b += other.shown_b;
    variance_a += other.variance_a;
    variance_b += other.variance_b;
    square_a += other.square_a;
    square_b += other.square_b;
    third_a += other.third_a;
    third_b += other.third_b;
    third_error_a += other.third_error_a;
    third_error_b += other.third_error_b;
}

DifferenceSums sums_of(const Picture& a, const Picture& b, const PixelBox& box, std::size_t channel) {
    DifferenceSums sums;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            const std::size_t k = a.at(x, y, channel);
            if (!good(a, b, k)) continue;
            const double va = a.variance[k] + a.variance_rounding, vb = b.variance[k] + b.variance_rounding;
            const double reach = 2 * std::sqrt(va + vb);
            const double e = std::clamp(a.mean[k] - b.mean[k] - around(a, b, x, y, channel), -reach, reach);
            ++sums.pixels;
            sums.a += a.mean[k];
            sums.b += b.mean[k];
            sums.rounding += a.rounding_at(k) + b.rounding_at(k);
            sums.shown_a += a.variance[k];
            sums.shown_b += b.variance[k];
            sums.variance_a += va;
            sums.variance_b += vb;
            sums.square_a += finite_part(va, a.degrees);
            sums.square_b += finite_part(vb, b.degrees);
            sums.third_a += e * va;
            sums.third_b -= e * vb;
            sums.third_error_a += e * e * va * va;
            sums.third_error_b += e * e * vb * vb;
        }
    return sums;
}

double largest_spike(const Picture& a, const Picture& b, std::size_t channel) {
    double largest = 0;
    for (std::size_t k = channel; k < a.mean.size(); k += a.channels.size())
        if (good(a, b, k)) largest = std::max(largest, a.variance[k] + b.variance[k]);
    return std::sqrt(largest);
}

double normal_score_of_student(double t, double degrees_of_freedom) {
    return score_of_tail(student_two_sided_tail(t, degrees_of_freedom) / 2);
}

double skewed_p_value(double z, double skewness) {
    z = std::min(std::abs(z), largest_score);
    if (skewness <= 0) return normal_two_sided_tail(z);
    // K spikes where n were expected, and their variance estimated as K: z = (n − K)/√K, K = n (1 − missing).
    const double n = 1 / (skewness * skewness), w = z * z / n;
    const double missing = w > 0 ? 2 / (1 + std::sqrt(1 + 4 / w)) : 0;
    const double rate = n * (missing < 1 ? (1 - missing) * std::log1p(-missing) + missing : 1);
    return std::min(1.0, normal_two_sided_tail(z) * std::exp(std::max(0.0, z * z / 2 - rate)));
}

bool interval_is_trusted(const MeanDifference& found, double beta) {
    return found.skewness * std::pow(normal_upper_quantile(beta), 3) / 3 <= 1;
}

MeanDifference difference_of(const DifferenceSums& sums, const DifferenceSums& around, const DifferenceRules& rules) {
    const auto n = static_cast<double>(sums.pixels);
    MeanDifference found{.a = sums.a / n, .b = sums.b / n, .delta = rules.delta};
    found.difference = found.a - found.b;
    const double variance = variance_of(sums, rules.inflation), rounding = sums.rounding / n;
    const double excess = std::max(0.0, std::abs(found.difference) - rounding - rules.epsilon);
    found.standard_error = std::sqrt(variance) / n;
    found.degrees = std::numeric_limits<double>::infinity();
    if (variance == 0) {
        const double missing = rules.spike / n;  // of the mean, by a spike
        const double reach = excess > 0 ? rounding - std::log(rules.beta) * missing : 0;
        found.p_value = excess > 0 ? std::exp(-excess / missing) : 1;
        found.z = std::copysign(score_of_tail(found.p_value / 2), found.difference);
        found.interval = {found.difference - reach, found.difference + reach};
        return found;
    }
    found.degrees = degrees_of(sums, rules.inflation);
    // A sum over n of m pixels like these has √(m/n) times the skewness of the sum over m.
    const double share = std::sqrt(static_cast<double>(around.pixels) / n);
    found.skewness = std::max(skewness_of(sums, 2, rules.inflation), share * skewness_of(around, 0, rules.inflation));
    found.z = std::copysign(normal_score_of_student(excess / found.standard_error, found.degrees), found.difference);
    found.p_value = skewed_p_value(found.z, found.skewness);
    const double reach = student_upper_quantile(rules.beta, found.degrees) * found.standard_error + rounding;
    found.interval = {found.difference - reach, found.difference + reach};
    return found;
}

}  // namespace plumb
