// Russian roulette: expectation and variance over every outcome, mean, variance, cost.

#include <cmath>

#include "analytic/enumeration.h"
#include "estimators/debiasing/russian_roulette.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"
#include "verification/evidence/ratio.h"

namespace plumb::suites {
namespace {

/// What a survivor counts, given its value and q; `survives` with q.
template <class T>
using Reweighting = std::function<T(const T& value, const T& q)>;
template <class T>
T not_reweighted(const T& value, const T&) {
    return value;
}
/// A path whose next vertex has half the survival probability: divided by that one's q.
template <class T>
T with_next_q(const T& value, const T& q) {
    return value / (q / 2);
}

/// The library's roulette (empty reweighting), or a mutant's.
template <class T, class Value, class Random>
T roulette_value(const Reweighting<T>& reweighting, const T& q, const Value& value, Random& random) {
    if (!reweighting) return russian_roulette(q, value, random);
    return chance(q, random) ? reweighting(value(), q) : T(0);
}

/// A value of 1 or 5 with equal chances (mean 3, variance 4) through two roulettes, one inside the other.
Verdict roulette_enumerated(const Reweighting<Rational>& reweighting) {
    std::uint64_t outcomes = 0;
    for (const Rational& q : {Rational(1, 10), Rational(1, 2), Rational(2, 3), Rational(1)}) {
        const ExactMoments exact = enumerate([&](Choices& random) {
            const auto value = [&] { return random.chance({1, 2}) ? Rational(1) : Rational(5); };
            const auto inner = [&] { return roulette_value<Rational>(reweighting, {1, 3}, value, random); };
            return roulette_value<Rational>(reweighting, q, inner, random);
        });
        outcomes += exact.outcomes;
        const Rational variance = roulette_variance<Rational>(3, roulette_variance<Rational>(3, 4, {1, 3}), q);
        if (exact.mean != 3 || exact.variance != variance)
            return exactly(false, outcomes,
                           fmt::format("q = {}: mean {} for 3, variance {} for {}", q.str(), exact.mean.str(),
                                       exact.variance.str(), variance.str()));
    }
    return exactly(true, outcomes, "mean and variance are as predicted for every q");
}

constexpr double survival = 0.3;

/// exp(U), mean e − 1, through one roulette.
Draw rouletted_exp(Reweighting<double> reweighting) {
    return [reweighting](RandomStream& random) {
        const double u = random.uniform();
        return roulette_value(
            reweighting, survival, [u] { return std::exp(u); }, random);
    };
}

Verdict roulette_mean(const Reweighting<double>& reweighting, const Run& run) {
    return mean_is(rouletted_exp(reweighting),
                   {.reference = std::exp(1) - 1, .delta = 0.02, .bounds = {0, std::exp(1) / survival}}, run);
}

Verdict roulette_variance_is(const Reweighting<double>& reweighting, const Run& run) {
    const double e = std::exp(1);
    const double plain = (e * e - 1) / 2 - (e - 1) * (e - 1);
    return variance_is(rouletted_exp(reweighting), roulette_variance(e - 1, plain, survival), 0.05, 30000, run,
                       "values between 0 and e over the survival probability");
}

/// The verdict on how often the integrand is evaluated in 10 trials.
Verdict roulette_cost(double q, const Run& run) {
    const Draw count = [q](RandomStream& random) {
        return static_cast<double>(roulette<1>([](const Point<1>& x) { return x[0]; }, q, 10, random).evaluations);
    };
    return mean_is(count, {.reference = 10 * survival, .delta = 0.05, .bounds = {0, 10}}, run);
}

}  // namespace

void add_debiasing_roulette(Catalogue& catalogue) {
    catalogue.add({
        .id = "debiasing/roulette/expectation",
        .statement =
            "Nested Russian roulettes keep the mean and have the variance (σ² + μ²)/q − μ², over every outcome.",
        .source = "[Arvo & Kirk 1990]; variance ours, estimators/debiasing/russian_roulette.h",
        .kind = Kind::exact,
        .trial = {roulette_enumerated,
                  {},
                  {{"not-reweighted", "Survivors are not divided by q.", not_reweighted<Rational>},
                   {"next-q", "Survivors are divided by the survival probability of the next vertex.",
                    with_next_q<Rational>}}},
    });
    catalogue.add({
        .id = "debiasing/roulette/mean",
        .statement = "Russian roulette keeps the mean.",
        .source = "[Arvo & Kirk 1990]",
        .kind = Kind::mean,
        .trial = {roulette_mean,
                  {},
                  {{"not-reweighted", "Survivors are not divided by q.", not_reweighted<double>},
                   {"rounded-q", "Survivors are divided by 0.31, the probability of another table's row.",
                    [](double value, double q) { return value / (q + 0.01); }}}},
    });
    catalogue.add({
        .id = "debiasing/roulette/variance",
        .statement = "The variance of roulette is (σ² + μ²)/q − μ².",
        .source = "ours, estimators/debiasing/russian_roulette.h",
        .kind = Kind::ratio,
        .trial = {roulette_variance_is,
                  {},
                  {{"next-q", "Survivors are divided by the survival probability of the next vertex.",
                    with_next_q<double>},
                   {"rounded-q", "Survivors are divided by 0.32, not 0.3.",
                    [](double value, double q) { return value / (q + 0.02); }}}},
    });
    catalogue.add({
        .id = "debiasing/roulette/cost",
        .statement = "Roulette with q evaluates n q times on average.",
        .source = "ours, estimators/debiasing/russian_roulette.h",
        .kind = Kind::mean,
        .trial = {roulette_cost, survival, {{"other-q", "q is 0.315, not 0.3.", 0.315}}},
    });
}

}  // namespace plumb::suites
