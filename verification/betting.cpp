#include "verification/betting.h"

#include <algorithm>
#include <cmath>

#include "verification/distributions.h"

namespace plumb {
namespace {

constexpr std::uint64_t warm_up = 32;  // without bounds, no bet before the variance can be guessed

// The guard on skewness is never laxer than at this level: at 1e-2 it would let a fifth of x^-1/2 end in a verdict.
constexpr double guard_level = 1e-6;

// log of the product of max(1 + lambda (x − m), floor) over the block, with a logarithm every few factors only.
double log_growth(std::span<const double> block, double lambda, double m) {
    constexpr std::size_t stride = 16;
    constexpr double floor = 0x1p-40;  // 16 floors multiply to no underflow
    double log_product = 0;
    for (std::size_t begin = 0; begin < block.size(); begin += stride) {
        const std::size_t end = std::min(begin + stride, block.size());
        double product = 1;
        for (std::size_t i = begin; i < end; ++i) product *= std::max(1 + lambda * (block[i] - m), floor);
        log_product += std::log(product);
    }
    return log_product;
}

Moments moments_of(std::span<const double> block) {
    Moments moments;
    for (const double x : block) moments.add(x);
    return moments;
}

}  // namespace

MeanTest::MeanTest(const Setting& setting)
    : setting_(setting),
      exact_below_(std::isfinite(setting.bounds.low)),
      exact_above_(std::isfinite(setting.bounds.high)),
      against_large_{setting.resolved.high, -1},
      against_small_{setting.resolved.low, +1},
      z_guard_(normal_upper_quantile(std::min(setting.alpha, guard_level) / 2)) {
    for (int j = 0; j < scales; ++j) {
        const double scale = std::ldexp(1.0, j - 1);
        if (std::isfinite(setting.allowed.high)) against_claim_.push_back({setting.allowed.high, scale});
        if (std::isfinite(setting.allowed.low)) against_claim_.push_back({setting.allowed.low, -scale});
    }
}

std::size_t MeanTest::block_size() const {
    return moments_.count() < 1024 ? 16 : 64;
}

double MeanTest::variance_guess() const {
    const auto n = static_cast<double>(moments_.count());
    const double sum_of_squares = moments_.count() > 1 ? moments_.variance() * (n - 1) : 0;
    if (exact()) {  // one value in advance, as far out as the bounds allow: never zero
        const double half = setting_.bounds.width() / 2;
        return (sum_of_squares + half * half) / (n + 1);
    }
    return moments_.count() < warm_up ? 0 : sum_of_squares / (n - 1);
}

double MeanTest::lambda(const Bet& bet, double variance) const {
    if (!(variance > 0)) return 0;  // zero sample variance decides nothing
    // The worst value for this bet lies at the bound that it bets away from.
    const bool bounded = bet.scale > 0 ? exact_below_ : exact_above_;
    const double reach = bet.scale > 0 ? bet.m - setting_.bounds.low : setting_.bounds.high - bet.m;
    const double cap = bounded ? (reach > 0 ? 0.5 / reach : 0.0) : 0.25 / std::sqrt(variance);
    return std::copysign(std::min(std::abs(bet.scale) * setting_.delta / variance, cap), bet.scale);
}

MeanTest::Decision MeanTest::add(std::span<const double> block) {
    const double variance = variance_guess();
    const auto play = [&](Bet& bet) { bet.log_wealth += log_growth(block, lambda(bet, variance), bet.m); };
    for (Bet& bet : against_claim_) play(bet);
    for (Bet* bet : {&against_large_, &against_small_})
        if (std::isfinite(bet->m)) play(*bet);
    moments_.merge(moments_of(block));

    max_log_claim_ = std::max(max_log_claim_, log_evidence());
    max_log_large_ = std::max(max_log_large_, against_large_.log_wealth);
    max_log_small_ = std::max(max_log_small_, against_small_.log_wealth);
    if (moments_.count() < setting_.min_samples || !tails_allow_a_decision()) return Decision::none;
    if (max_log_claim_ >= -std::log(setting_.alpha)) return Decision::refuted;
    const auto excluded = [&](const Bet& bet, double max_log) {
        return std::isinf(bet.m) || max_log >= -std::log(setting_.beta);
    };
    if (excluded(against_large_, max_log_large_) && excluded(against_small_, max_log_small_)) return Decision::holds;
    return Decision::none;
}

double MeanTest::p_value() const {
    return std::exp(-max_log_claim_);
}

double MeanTest::log_evidence() const {
    double top = against_claim_.front().log_wealth;
    for (const Bet& bet : against_claim_) top = std::max(top, bet.log_wealth);
    double sum = 0;
    for (const Bet& bet : against_claim_) sum += std::exp(bet.log_wealth - top);
    return top + std::log(sum / static_cast<double>(against_claim_.size()));
}

bool MeanTest::tails_allow_a_decision() const {
    if (exact()) return true;
    const double n = static_cast<double>(moments_.count());
    return std::abs(moments_.skewness()) * std::pow(z_guard_, 3) / (3 * std::sqrt(n)) <= 1;  // false for NaN
}

Interval MeanTest::mean_interval() const {
    // Robbins' normal mixture, sharpest near the sample count at which the claim is decided.
    const double n = static_cast<double>(moments_.count()), variance = moments_.variance();
    const double rho2 = setting_.delta * setting_.delta / (10 * variance);
    const double a = n * rho2 + 1;
    const double half = std::sqrt(variance * 2 * a / (n * n * rho2) * std::log(std::sqrt(a) / setting_.beta));
    return std::isfinite(half) ? Interval{moments_.mean() - half, moments_.mean() + half} : Interval{};
}

}  // namespace plumb
