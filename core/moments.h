#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace plumb {

/// Count, mean and central moments up to the fourth, updated one value at a time or merged.
/// [Pébay 2008, eqs. 1.1–1.6]: no cancellation between a large mean and a small spread.
class Moments {
public:
    /// Moments of a block in two passes, mean and then powers of the differences from it, whose lanes become vectors.
    static Moments of(std::span<const double> values) {
        Moments m;
        if (values.empty()) return m;
        const double n = static_cast<double>(values.size());
        m.count_ = values.size();
        m.mean_ = sums<1>(values, [](double x) { return std::array{x}; })[0] / n;
        const auto powers = [mean = m.mean_](double x) {
            const double d = x - mean, d2 = d * d;
            return std::array{d2, d2 * d, d2 * d2};
        };
        const std::array<double, 3> central = sums<3>(values, powers);
        m.m2_ = central[0];
        m.m3_ = central[1];
        m.m4_ = central[2];
        return m;
    }

    void add(double x) {
        const double n1 = static_cast<double>(count_);
        ++count_;
        const double n = static_cast<double>(count_);
        const double delta = x - mean_;
        const double step = delta / n;
        const double term = delta * step * n1;
        mean_ += step;
        m4_ += term * step * step * (n * n - 3 * n + 3) + 6 * step * step * m2_ - 4 * step * m3_;
        m3_ += term * step * (n - 2) - 3 * step * m2_;
        m2_ += term;
    }

    void merge(const Moments& other) {
        if (other.count_ == 0) return;
        const double a = static_cast<double>(count_), b = static_cast<double>(other.count_), n = a + b;
        const double delta = other.mean_ - mean_, step = delta / n;
        m4_ += other.m4_ + delta * step * step * step * a * b * (a * a - a * b + b * b) +
               6 * step * step * (a * a * other.m2_ + b * b * m2_) + 4 * step * (a * other.m3_ - b * m3_);
        m3_ += other.m3_ + delta * step * step * a * b * (a - b) + 3 * step * (a * other.m2_ - b * m2_);
        m2_ += other.m2_ + delta * step * a * b;
        mean_ += step * b;
        count_ += other.count_;
    }

    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] double mean() const { return count_ > 0 ? mean_ : not_known; }
    /// Unbiased variance of one value; infinite for fewer than two: unknown is not zero.
    [[nodiscard]] double variance() const {
        return count_ > 1 ? m2_ / static_cast<double>(count_ - 1) : std::numeric_limits<double>::infinity();
    }
    /// Standard error of the mean; infinite for fewer than two values.
    [[nodiscard]] double standard_error() const { return std::sqrt(variance() / static_cast<double>(count_)); }
    [[nodiscard]] double skewness() const {
        return m2_ > 0 ? std::sqrt(static_cast<double>(count_)) * m3_ / std::pow(m2_, 1.5) : not_known;
    }
    /// Fourth standardised moment (3 for a normal distribution).
    [[nodiscard]] double kurtosis() const {
        return m2_ > 0 ? static_cast<double>(count_) * m4_ / (m2_ * m2_) : not_known;
    }

private:
    // Sums of terms(x) over all values, in a fixed order: every eighth value, then the eight partial sums.
    template <std::size_t K, class Terms>
    static std::array<double, K> sums(std::span<const double> values, const Terms& terms) {
        constexpr std::size_t lanes = 8;
        std::array<std::array<double, lanes>, K> partial{};
        const auto add_one = [&](std::size_t lane, double x) {
            const std::array<double, K> term = terms(x);
            for (std::size_t k = 0; k < K; ++k) partial[k][lane] += term[k];
        };
        const std::size_t whole = values.size() / lanes * lanes;
        for (std::size_t i = 0; i < whole; i += lanes)
            for (std::size_t lane = 0; lane < lanes; ++lane) add_one(lane, values[i + lane]);
        for (std::size_t i = whole; i < values.size(); ++i) add_one(i - whole, values[i]);
        std::array<double, K> total{};
        for (std::size_t k = 0; k < K; ++k)
            for (const double part : partial[k]) total[k] += part;
        return total;
    }

    static constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
    std::uint64_t count_ = 0;
    double mean_ = 0, m2_ = 0, m3_ = 0, m4_ = 0;
};

}  // namespace plumb
