#include "checks/sampler/uniformity.h"

#include <algorithm>
#include <cmath>

namespace plumb::checks {
namespace {

// The Kullback–Leibler divergence of a coin of probability p from one of probability q.
double divergence(double p, double q) {
    const auto term = [](double a, double b) { return a > 0 ? a * std::log(a / b) : 0; };
    return term(p, q) + term(1 - p, 1 - q);
}

}  // namespace

void Uniformity::add(double u) {
    const auto bins = static_cast<double>(bins_.size());
    ++bins_[static_cast<std::size_t>(std::clamp(u * bins, 0.0, bins - 1))];
    ++count_;
}

Unevenness Uniformity::cumulative() const {
    const auto n = static_cast<double>(count_), bins = static_cast<double>(bins_.size());
    Unevenness worst{0, 0, 0, 1};
    double distance = 0, sum = 0;
    for (std::size_t i = 0; i < bins_.size(); ++i) {
        sum += static_cast<double>(bins_[i]);
        const double u = static_cast<double>(i + 1) / bins;
        if (const double here = std::abs(sum / n - u); here > distance) {
            distance = here;
            worst.high = u;
            worst.found = sum / n;
        }
    }
    worst.p_value = std::min(1.0, 2 * std::exp(-2 * n * distance * distance));
    return worst;
}

Unevenness Uniformity::dyadic() const {
    const auto n = static_cast<double>(count_);
    std::vector<std::uint64_t> counts = bins_;
    double most = 0;  // of n times the divergence
    Unevenness worst;
    for (int level = levels; level >= 1; --level) {
        const double q = std::exp2(-level);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const double p = static_cast<double>(counts[i]) / n;
            if (const double here = n * divergence(p, q); here > most) {
                most = here;
                worst = {static_cast<double>(i) * q, static_cast<double>(i + 1) * q, p, 1};
            }
        }
        for (std::size_t i = 0; i < counts.size() / 2; ++i) counts[i] = counts[2 * i] + counts[2 * i + 1];
        counts.resize(counts.size() / 2);
    }
    const double tails = 2 * 2 * static_cast<double>(bins_.size());  // of fewer than twice as many intervals
    worst.p_value = std::min(1.0, tails * std::exp(-most));
    return worst;
}

}  // namespace plumb::checks
