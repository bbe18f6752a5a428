#include "verification/evidence/betting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

constexpr double floor_of_factors = 0x1p-6;  // a value that would leave less of a bet without bounds ruins it

constexpr std::uint64_t warm_up = 32;  // without bounds, no bet before the variance can be guessed

// The guard on skewness is never laxer than at this level: at 1e-2 it would let a fifth of x^-1/2 end in a verdict.
constexpr double guard_level = 1e-6;

// log-wealth against ±delta grows by c − c²/2 and fluctuates by c when the bet is c delta/variance. The fastest growth,
// c = 1, leaves a true claim undecided at the cap 10 times as often as 3/4, which costs 6 % more samples.
constexpr double holding_scale = 0.75;

// The product of 1 + lambda (x − m) over a block: sixteen partial products, which the compiler turns into vectors. It
// may overflow to infinity or, without bounds, underflow to 0: that is what the bet is worth then.
double growth(double lambda, double m, std::span<const double> block) {
    constexpr std::size_t lanes = 16;
    const double intercept = 1 - lambda * m;
    const auto factor = [=](double x) { return std::max(std::fma(lambda, x, intercept), floor_of_factors); };
    std::array<double, lanes> product;
    product.fill(1);
    const std::size_t whole = block.size() / lanes * lanes;
    for (std::size_t i = 0; i < whole; i += lanes)
#pragma GCC unroll 16  // keeps the products in registers
        for (std::size_t lane = 0; lane < lanes; ++lane) product[lane] *= factor(block[i + lane]);
    for (std::size_t i = whole; i < block.size(); ++i) product[i - whole] *= factor(block[i]);
    return std::accumulate(product.begin(), product.end(), 1.0, std::multiplies());
}

}  // namespace

MeanTest::MeanTest(const Setting& setting)
    : setting_(setting),
      exact_below_(std::isfinite(setting.bounds.low)),
      exact_above_(std::isfinite(setting.bounds.high)),
      against_large_{setting.resolved.high, -holding_scale},
      against_small_{setting.resolved.low, +holding_scale},
      z_guard_(normal_upper_quantile(std::min(setting.alpha, guard_level) / 2)) {
    for (int j = 0; j < scales; ++j) {
        const double scale = j + 1 < scales ? std::ldexp(1.0, j - 1) : std::numeric_limits<double>::infinity();
        if (std::isfinite(setting.allowed.high)) against_claim_.push_back({setting.allowed.high, scale});
        if (std::isfinite(setting.allowed.low)) against_claim_.push_back({setting.allowed.low, -scale});
    }
}

std::size_t MeanTest::block_size() const {
    return moments_.count() < 1024 ? 16 : moments_.count() < 16384 ? 64 : largest_block;
}

double MeanTest::variance_guess(std::uint64_t least_seen) const {
    const auto n = static_cast<double>(moments_.count());
    const double sum_of_squares = moments_.count() > 1 ? moments_.variance() * (n - 1) : 0;
    if (exact()) {  // one value in advance, as far out as the bounds allow: never zero
        const double half = setting_.bounds.width() / 2;
        return (sum_of_squares + half * half) / (n + 1);
    }
    return moments_.count() < least_seen ? 0 : sum_of_squares / (n - 1);
}

double MeanTest::lambda(const Bet& bet, double variance) const {
    if (!(variance > 0)) return 0;  // zero sample variance decides nothing
    // The worst value for this bet lies at the bound that it bets away from; where that is unknown, at the worst so
    // far.
    const bool up = bet.scale > 0;
    const double worst =
        is_exact(bet) ? (up ? setting_.bounds.low : setting_.bounds.high) : (up ? seen_.low : seen_.high);
    const double reach = std::max(up ? bet.m - worst : worst - bet.m, 0.0);
    const double cap = std::min(0.5 / reach, 0.25 / std::sqrt(variance));
    return std::copysign(std::min(std::abs(bet.scale) * setting_.delta / variance, cap), bet.scale);
}

// A value farther out than all before it may ruin a bet without bounds. What the bet had won while it could not know
// better is then forfeited: else hundreds of values without a spike win more than any number of spikes takes back.
void MeanTest::play(std::span<const double> block, const Interval& values) {
    const double of_exact = variance_guess(warm_up),
                 of_others = exact() ? 0 : variance_guess(std::max(warm_up, setting_.min_samples));
    const auto settle = [&](Bet& bet) {
        const bool is_safe = is_exact(bet);
        const double slope = std::isfinite(bet.m) ? lambda(bet, is_safe ? of_exact : of_others) : 0;
        if (slope == 0) return;
        bet.log_wealth += std::log(growth(slope, bet.m, block));
        if (is_safe) return;
        const bool ruined = 1 + slope * ((slope > 0 ? values.low : values.high) - bet.m) < floor_of_factors;
        if (ruined) bet.log_wealth = std::min(bet.log_wealth, std::log(floor_of_factors));
    };
    for (Bet& bet : against_claim_) settle(bet);
    settle(against_large_);
    settle(against_small_);
}

// A bet without bounds grows while the tail that will ruin it has not been seen, so its past is not held against the
// claim: only looks at which the tails allow a decision count.
void MeanTest::record_maxima() {
    const bool calm = tails_allow_a_decision() && moments_.count() >= setting_.min_samples;
    // A mixture is worth at most its best bet, so most looks need no sum of exponentials.
    const double best = std::ranges::max_element(against_claim_, {}, &Bet::log_wealth)->log_wealth;
    if (best > max_log_exact_ && (exact_below_ || exact_above_))
        max_log_exact_ = std::max(max_log_exact_, log_evidence(true));
    if (best > max_log_claim_ && calm && !exact()) max_log_claim_ = std::max(max_log_claim_, log_evidence(false));
    max_log_claim_ = std::max(max_log_claim_, max_log_exact_);
    if (calm || is_exact(against_large_)) max_log_large_ = std::max(max_log_large_, against_large_.log_wealth);
    if (calm || is_exact(against_small_)) max_log_small_ = std::max(max_log_small_, against_small_.log_wealth);
}

MeanTest::Decision MeanTest::add(std::span<const double> block) {
    Interval values;
    if (!exact()) {
        const auto [least, most] = std::ranges::minmax(block);
        values = {least, most};
    }
    play(block, values);
    moments_.merge(Moments::of(block));
    if (!exact()) seen_ = {std::min(seen_.low, values.low), std::max(seen_.high, values.high)};
    record_maxima();
    if (max_log_claim_ >= -std::log(setting_.alpha)) return Decision::refuted;
    if (moments_.count() < setting_.min_samples) return Decision::none;
    return excludes_large() && excludes_small() ? Decision::holds : Decision::none;
}

bool MeanTest::excludes_large() const {
    return std::isinf(against_large_.m) || max_log_large_ >= -std::log(setting_.beta);
}

bool MeanTest::excludes_small() const {
    return std::isinf(against_small_.m) || max_log_small_ >= -std::log(setting_.beta);
}

bool MeanTest::refuted_exactly() const {
    return max_log_exact_ >= -std::log(setting_.alpha);
}

double MeanTest::p_value() const {
    return std::exp(-max_log_claim_);
}

// The bets left out count as lost: what remains of the mixture is a smaller supermartingale.
double MeanTest::log_evidence(bool exact_bets_only) const {
    const auto counts = [&](const Bet& bet) { return !exact_bets_only || is_exact(bet); };
    double top = -std::numeric_limits<double>::infinity();
    for (const Bet& bet : against_claim_)
        if (counts(bet)) top = std::max(top, bet.log_wealth);
    if (std::isinf(top)) return top;
    double sum = 0;
    for (const Bet& bet : against_claim_)
        if (counts(bet)) sum += std::exp(bet.log_wealth - top);
    return top + std::log(sum / static_cast<double>(against_claim_.size()));
}

bool MeanTest::tails_allow_a_decision() const {
    if (exact()) return true;
    const double n = static_cast<double>(moments_.count());
    return std::abs(moments_.skewness()) * std::pow(z_guard_, 3) / (3 * std::sqrt(n)) <= 1;  // false for NaN
}

Interval MeanTest::mean_interval() const {
    // Robbins' normal mixture [Waudby-Smith et al. 2024, eq. 13]. n rho² = 11.5 is sharpest at beta = 1e-2; `holds` is
    // reached near n = 14 (sigma/delta)².
    const double n = static_cast<double>(moments_.count()), variance = moments_.variance();
    const double rho2 = 11.5 / 14 * setting_.delta * setting_.delta / variance;
    const double a = n * rho2 + 1;
    const double half = std::sqrt(variance * 2 * a / (n * n * rho2) * std::log(std::sqrt(a) / setting_.beta));
    if (!std::isfinite(half)) return {};
    Interval interval{moments_.mean() - half, moments_.mean() + half};
    // What the bets have excluded, each end at risk beta, sharpens it.
    if (excludes_large()) interval.high = std::min(interval.high, setting_.resolved.high);
    if (excludes_small()) interval.low = std::max(interval.low, setting_.resolved.low);
    return interval;
}

}  // namespace plumb
