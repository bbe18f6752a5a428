// Multiple importance sampling, exactly: every small case of the weights, every outcome of both estimators, and Veach's
// theorems on the balance heuristic over all weights of a grid.

#include <array>

#include "analytic/enumeration.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/suites/mis/mis_subjects.h"

namespace plumb::suites {
namespace {

using Rationals = std::vector<Rational>;

// ---- exact: every small case

/// Calls body(counts, pdfs) for all integer counts 0 … 2 and pdfs 0 … 3 of one, two and three techniques.
template <class Body>
std::uint64_t for_small_cases(const Body& body) {
    std::uint64_t cases = 0;
    for (std::size_t techniques = 1, combinations = 12; techniques <= 3; ++techniques, combinations *= 12)
        for (std::size_t code = 0; code < combinations; ++code, ++cases) {
            Rationals n, p;
            for (std::size_t i = 0, rest = code; i < techniques; ++i, rest /= 12) {
                n.emplace_back(rest % 3);
                p.emplace_back(rest / 3 % 4);
            }
            body(n, p);
        }
    return cases;
}

std::string text(const Rationals& values) {
    std::string list;
    for (const Rational& value : values) list += (list.empty() ? "" : ", ") + value.str();
    return "(" + list + ")";
}

/// The weights sum to 1 wherever a technique can sample, and vanish elsewhere.
Verdict sums_to_one(const std::vector<Weights<Rational>>& heuristics) {
    std::string failure;
    const std::uint64_t cases = for_small_cases([&](const Rationals& n, const Rationals& p) {
        Rational possible = 0;
        for (std::size_t i = 0; i < n.size(); ++i) possible += n[i] * p[i];
        for (std::size_t h = 0; h < heuristics.size(); ++h) {
            const Rationals w = heuristics[h](n, p);
            const Rational sum = std::accumulate(w.begin(), w.end(), Rational(0));
            bool right = sum == (possible > 0 ? 1 : 0);
            for (std::size_t i = 0; i < n.size(); ++i) right = right && w[i] >= 0 && (n[i] * p[i] > 0 || w[i] == 0);
            if (!right && failure.empty())
                failure = fmt::format("heuristic {}, counts {}, pdfs {}: weights {}", h, text(n), text(p), text(w));
        }
    });
    return exactly(failure.empty(), cases * heuristics.size(),
                   failure.empty() ? "every sum is 1, or 0 where no technique can sample" : failure);
}

/// The weights are (n_i p_i)^power / Σ (n_k p_k)^power.
Verdict is_power_of_np(const Weights<Rational>& heuristic, int power) {
    std::string failure;
    const std::uint64_t cases = for_small_cases([&](const Rationals& n, const Rationals& p) {
        Rationals w(n.size());
        Rational sum = 0;
        for (std::size_t i = 0; i < n.size(); ++i) {
            w[i] = n[i] * p[i];
            if (power == 2) w[i] *= w[i];
            sum += w[i];
        }
        for (Rational& value : w)
            if (sum > 0) value /= sum;
        const Rationals found = heuristic(n, p);
        if (found != w && failure.empty())
            failure = fmt::format("counts {}, pdfs {}: {} for {}", text(n), text(p), text(found), text(w));
    });
    return exactly(failure.empty(), cases, failure.empty() ? "all weights agree" : failure);
}

// ---- exact: estimators on a domain of three points

const std::array<Rationals, 3> pmf_pairs[] = {
    {Rationals{{1, 2}, {1, 2}, 0}, Rationals{{1, 6}, {1, 3}, {1, 2}}, {}},
    {Rationals{1, 0, 0}, Rationals{{1, 3}, {1, 3}, {1, 3}}, {}},
    {Rationals{{1, 10}, {1, 10}, {4, 5}}, Rationals{{3, 5}, {1, 5}, {1, 5}}, {}},
};

Rationals at(const std::array<Rationals, 3>& pmfs, std::size_t x) {
    return {pmfs[0][x], pmfs[1][x]};
}

/// The expectation over all outcomes is Σ f, for samples in these counts.
Verdict multi_sample_is_unbiased(const Contribution<Rational>& contribution) {
    const Rationals f{3, -1, 5};
    std::uint64_t outcomes = 0;
    for (const auto& pmfs : pmf_pairs)
        for (const Rationals& n : {Rationals{0, 1}, Rationals{1, 1}, Rationals{2, 1}, Rationals{1, 3}}) {
            const ExactMoments exact = enumerate([&](Choices& random) {
                Rational estimate = 0;
                for (std::size_t i = 0; i < 2; ++i)
                    for (int j = 0; j < n[i]; ++j) {
                        const std::size_t x = random.choose(pmfs[i]);
                        estimate += contribution(i, f[x], n, at(pmfs, x));
                    }
                return estimate;
            });
            outcomes += exact.outcomes;
            if (exact.mean != 7)
                return exactly(false, outcomes, fmt::format("counts {}: mean {} for 7", text(n), exact.mean.str()));
        }
    return exactly(true, outcomes, "every mean is the sum of f");
}

Verdict one_sample_is_unbiased(const Contribution<Rational>& contribution) {
    const Rationals f{3, -1, 5};
    std::uint64_t outcomes = 0;
    for (const auto& pmfs : pmf_pairs)
        for (const Rationals& c : {Rationals{{1, 2}, {1, 2}}, Rationals{{1, 4}, {3, 4}}, Rationals{0, 1}}) {
            const ExactMoments exact = enumerate([&](Choices& random) {
                const std::size_t i = random.choose(c), x = random.choose(pmfs[i]);
                return contribution(i, f[x], c, at(pmfs, x));
            });
            outcomes += exact.outcomes;
            if (exact.mean != 7)
                return exactly(false, outcomes,
                               fmt::format("probabilities {}: mean {} for 7", text(c), exact.mean.str()));
        }
    return exactly(true, outcomes, "every mean is the sum of f");
}

/// w[x] = the weight of technique 0 at x; technique 1 gets the rest.
using WeightTable = std::array<Rational, 3>;

WeightTable table_of(const Weights<Rational>& heuristic, const Rationals& n, const std::array<Rationals, 3>& pmfs) {
    WeightTable w;
    for (std::size_t x = 0; x < 3; ++x) w[x] = heuristic(n, at(pmfs, x))[0];
    return w;
}

/// All tables of weights 0, 1/2, 1 that are 0 for a technique that cannot sample the point.
std::vector<WeightTable> grid_of_weights(const std::array<Rationals, 3>& pmfs) {
    std::vector<WeightTable> tables;
    for (int code = 0; code < 27; ++code) {
        const WeightTable w{Rational(code % 3, 2), Rational(code / 3 % 3, 2), Rational(code / 9, 2)};
        bool valid = true;
        for (std::size_t x = 0; x < 3; ++x)
            valid = valid && (pmfs[0][x] > 0 || w[x] == 0) && (pmfs[1][x] > 0 || w[x] == 1);
        if (valid) tables.push_back(w);
    }
    return tables;
}

/// Σ_i (1/n_i) (Σ_x (w_i f)²/p_i − (Σ_x w_i f)²); one-sample: without the second term but for μ², c_i for n_i.
Rational mis_variance(const WeightTable& w, const Rationals& f, const Rationals& n,
                      const std::array<Rationals, 3>& pmfs, bool one_sample) {
    Rational variance = 0, total = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        Rational second = 0, mean = 0;
        for (std::size_t x = 0; x < 3; ++x) {
            const Rational wf = (i == 0 ? w[x] : Rational(1 - w[x])) * f[x];
            if (wf != 0) second += wf * wf / pmfs[i][x];
            mean += wf;
        }
        total += mean;
        variance += (one_sample ? second : Rational(second - mean * mean)) / n[i];
    }
    return one_sample ? Rational(variance - total * total) : variance;
}

/// Calls body(f, pmfs) for all nonzero f of three values from low to low + 2.
template <class Body>
void for_problems(int low, const Body& body) {
    for (const auto& pmfs : pmf_pairs)
        for (int code = 0; code < 27; ++code) body(Rationals{code % 3 + low, code / 3 % 3 + low, code / 9 + low}, pmfs);
}

/// Weights, said to be bounded for integrands whose values are from lowest_f to lowest_f + 2.
struct Bounded {
    Weights<Rational> heuristic;
    int lowest_f;
};

/// V[F̂] ≤ V[F] + (1/min n − 1/Σn) μ² for every table of weights F, F̂ with these weights?
Verdict variance_bound(const Bounded& subject) {
    const auto& [heuristic, lowest_f] = subject;
    std::string failure;
    std::uint64_t cases = 0;
    for_problems(lowest_f, [&](const Rationals& f, const std::array<Rationals, 3>& pmfs) {
        for (const Rationals& n : {Rationals{1, 1}, Rationals{1, 8}, Rationals{8, 1}}) {
            const Rational mu = f[0] + f[1] + f[2];
            const Rational slack = (1 / std::min(n[0], n[1]) - 1 / Rational(n[0] + n[1])) * mu * mu;
            const Rational found = mis_variance(table_of(heuristic, n, pmfs), f, n, pmfs, false);
            for (const WeightTable& w : grid_of_weights(pmfs)) {
                ++cases;
                const Rational other = mis_variance(w, f, n, pmfs, false);
                if (found > other + slack && failure.empty())
                    failure = fmt::format("f {}, counts {}: variance {} > {} + {}", text(f), text(n), found.str(),
                                          other.str(), slack.str());
            }
        }
    });
    return exactly(failure.empty(), cases, failure.empty() ? "the bound holds in every case" : failure);
}

Verdict least_one_sample_variance(const Weights<Rational>& heuristic) {
    std::string failure;
    std::uint64_t cases = 0;
    for_problems(-1, [&](const Rationals& f, const std::array<Rationals, 3>& pmfs) {
        for (const Rationals& c : {Rationals{{1, 2}, {1, 2}}, Rationals{{1, 5}, {4, 5}}}) {
            const Rational found = mis_variance(table_of(heuristic, c, pmfs), f, c, pmfs, true);
            std::vector<WeightTable> others = grid_of_weights(pmfs);
            for (const Weights<Rational>& other : all_heuristics<Rational>())
                others.push_back(table_of(other, c, pmfs));
            for (const WeightTable& w : others) {
                ++cases;
                const Rational variance = mis_variance(w, f, c, pmfs, true);
                if (found > variance && failure.empty())
                    failure = fmt::format("f {}, probabilities {}: variance {} > {}", text(f), text(c), found.str(),
                                          variance.str());
            }
        }
    });
    return exactly(failure.empty(), cases, failure.empty() ? "no weights do better" : failure);
}

using Q = Rational;
using Contributions = std::vector<Contribution<Q>>;

Contributions of_every_heuristic() {
    return {contribution<Q>(Balance{}), contribution<Q>(Power{}), contribution<Q>(Maximum{}),
            contribution<Q>(Cutoff{0.5})};
}

void add_definitions(Catalogue& catalogue) {
    catalogue.add({
        .id = "mis/weights/sum",
        .statement = "Balance, power, maximum and cutoff weights sum to 1 wherever a technique can sample, and are 0 "
                     "for every technique that cannot.",
        .source = "[Veach 1997, conditions W1 and W2]",
        .kind = Kind::exact,
        .trial = {sums_to_one,
                  all_heuristics<Q>(),
                  {{"power-not-normalised",
                    "Squares are divided by the sum of n p, not of (n p)².",
                    {over_the_balance_sum<Q>(Power{})}},
                   {"cutoff-not-renormalised",
                    "What is cut off is not given to the techniques that stay.",
                    {over_the_balance_sum<Q>(Cutoff{0.5})}}}},
    });
    catalogue.add({
        .id = "mis/balance/definition",
        .statement = "The balance weights are n_i p_i / Σ n_k p_k.",
        .source = "[Veach 1997, eq. 9.8]",
        .kind = Kind::exact,
        .trial = {[](const Weights<Rational>& heuristic) { return is_power_of_np(heuristic, 1); },
                  weights<Q>(Balance{}),
                  {{"wrong-counts", "The weights take every count for 1.", ignoring_counts<Q>()}}},
    });
    catalogue.add({
        .id = "mis/power/definition",
        .statement = "The power weights with β = 2 are (n_i p_i)² / Σ (n_k p_k)².",
        .source = "[Veach 1997, eq. 9.13]",
        .kind = Kind::exact,
        .trial = {[](const Weights<Rational>& heuristic) { return is_power_of_np(heuristic, 2); },
                  weights<Q>(Power{}),
                  {{"balance", "The exponent is forgotten.", weights<Q>(Balance{})}}},
    });
}

void add_expectations(Catalogue& catalogue) {
    catalogue.add({
        .id = "mis/multi-sample/expectation",
        .statement = "The multi-sample estimator has the expectation Σ f over every outcome, for every heuristic.",
        .source = "[Veach 1997, lemma 9.1]",
        .kind = Kind::exact,
        .trial = {[](const Contributions& all) { return all_of_each(multi_sample_is_unbiased, all); },
                  of_every_heuristic(),
                  {{"short-form-wrong-counts",
                    "f / Σ n_k p_k takes the counts in another order.",
                    {short_form_with_reversed_counts<Q>}},
                   {"power-not-normalised",
                    "Squares are divided by the sum of n p.",
                    {with_weights<Q>(over_the_balance_sum<Q>(Power{}))}}}},
    });
    catalogue.add({
        .id = "mis/one-sample/expectation",
        .statement = "The one-sample estimator has the expectation Σ f over every outcome, for every heuristic.",
        .source = "[Veach 1997, eq. 9.15]",
        .kind = Kind::exact,
        .trial = {[](const Contributions& all) { return all_of_each(one_sample_is_unbiased, all); },
                  of_every_heuristic(),
                  {{"without-c", "The value is not divided by the probability of the technique.", {without_c<Q>}},
                   {"cutoff-not-renormalised",
                    "What is cut off is not given to the techniques that stay.",
                    {with_weights<Q>(over_the_balance_sum<Q>(Cutoff{0.5}))}}}},
    });
}

void add_theorems(Catalogue& catalogue) {
    catalogue.add({
        .id = "mis/balance/variance-bound",
        .statement = "For f ≥ 0 no weights have a variance smaller than that of the balance heuristic by more than "
                     "(1/min n_i − 1/Σ n_i) μ².",
        .source = "[Veach 1997, theorem 9.2]",
        .kind = Kind::exact,
        .trial =
            {variance_bound,
             {weights<Q>(Balance{}), 0},
             {{"any-sign",
               "f may be negative: then μ says nothing of the techniques' shares μ_i.",
               {weights<Q>(Balance{}), -1}},
              {"plain-average", "The techniques that can sample a point share it equally.", {plain_average<Q>(), 0}}}},
    });
    catalogue.add({
        .id = "mis/balance/one-sample-optimal",
        .statement = "No weights give the one-sample estimator a smaller variance than the balance heuristic.",
        .source = "[Veach 1997, theorem 9.4]",
        .kind = Kind::exact,
        .trial = {least_one_sample_variance,
                  weights<Q>(Balance{}),
                  {{"power", "The power heuristic is claimed to be optimal.", weights<Q>(Power{})}}},
    });
}

}  // namespace

void add_mis_exact(Catalogue& catalogue) {
    add_definitions(catalogue);
    add_expectations(catalogue);
    add_theorems(catalogue);
}

}  // namespace plumb::suites
