// Multiple importance sampling in double: weights in the corners of overflow, means, variance and error bar of the
// estimators on densities.

#include <boost/math/quadrature/gauss.hpp>

#include "analytic/rational.h"
#include "estimators/densities/density.h"
#include "estimators/mis/mis_estimators.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"
#include "verification/evidence/ratio.h"
#include "verification/suites/mis/mis_subjects.h"

namespace plumb::suites {
namespace {

using Rationals = std::vector<Rational>;

// ---- bounded: doubles in the corners

struct Corner {
    std::string name;
    std::vector<double> counts, pdfs;
};

std::vector<Corner> corners() {
    std::vector<Corner> all;
    const double pdfs[] = {5e-324, 1e-300, 1e-155, 0.3, 1, 7e10, 1e155, 1e300, 1.7e308};
    const double counts[] = {1, 3, 1e15};
    for (const double p : pdfs)
        for (const double q : pdfs)
            for (const double n : counts)
                all.push_back({fmt::format("n {:g}, 3; p {:g}, {:g}, 0", n, p, q), {n, 3, 1}, {p, q, 0}});
    RandomStream random(1, stream_id("mis corners"));
    for (const std::size_t size : {10u, 1000u}) {
        Corner many{fmt::format("{} techniques", size), {}, {}};
        for (std::size_t i = 0; i < size; ++i) {
            many.counts.push_back(static_cast<double>(1 + random.below(100)));
            many.pdfs.push_back(std::exp(10 * random.uniform()));
        }
        all.push_back(std::move(many));
    }
    return all;
}

Verdict double_sums_to_one(const std::vector<Weights<double>>& heuristics) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<Corner> cases = corners();
    cases.push_back({"delta and 1e300", {1, 1}, {infinity, 1e300}});
    cases.push_back({"three deltas", {1, 3, 7}, {infinity, infinity, infinity}});
    std::vector<BoundedCase> errors;
    for (const Corner& corner : cases)
        for (const Weights<double>& heuristic : heuristics) {
            Rational sum = 0;
            bool finite = true;
            for (const double w : heuristic(corner.counts, corner.pdfs)) {
                finite = finite && std::isfinite(w);
                if (finite && w > 0x1p-200) sum += Rational(w);
            }
            const Rational off = abs(Rational(sum - 1));
            errors.push_back({corner.name, finite ? static_cast<double>(off) * 0x1p52 : infinity});
        }
    return stable(errors, 2, "sum of MIS weights", "case");
}

/// Weights said to be those of n p to this power.
struct PowerWeights {
    Weights<double> heuristic;
    int power;
};

/// Against the definition in rationals. Below 1e-290 the unit is 1e-306: such a weight changes no sum.
Verdict double_weights_are_right(const PowerWeights& weights) {
    const auto& [heuristic, power] = weights;
    std::vector<BoundedCase> errors;
    for (const Corner& corner : corners()) {
        Rationals np;
        Rational sum = 0;
        for (std::size_t i = 0; i < corner.pdfs.size() && i < 10; ++i) {
            const Rational value = Rational(corner.counts[i]) * Rational(corner.pdfs[i]);
            np.push_back(power == 1 ? value : Rational(value * value));
            sum += np.back();
        }
        if (corner.pdfs.size() > 10) continue;
        const std::vector<double> found = heuristic(corner.counts, corner.pdfs);
        double worst = 0, at_weight = 0;
        for (std::size_t i = 0; i < np.size(); ++i) {
            const double truth = static_cast<double>(Rational(np[i] / sum));
            const double error = truth > 1e-290 ? ulp_error(found[i], truth) : std::abs(found[i] - truth) / 1e-306;
            if (!(error <= worst)) worst = error, at_weight = truth;
        }
        errors.push_back({corner.name, worst, at_weight});
    }
    return stable(errors, 16, power == 1 ? "balance weights" : "power weights", "weight");
}

template <class Shape>
Weights<double> without_scaling(Shape shape) {
    return [shape](std::span<const double> n, std::span<const double> p) {
        std::vector<double> w(n.size());
        double sum = 0;
        for (std::size_t i = 0; i < n.size(); ++i) sum += w[i] = shape(n[i] * p[i]);
        for (double& value : w) value /= sum;
        return w;
    };
}

// ---- estimators on densities: f = 3x², ∫f = 1

const std::vector<Technique<1>>& techniques() {
    static const std::vector<Technique<1>> all{technique_1d("uniform", UniformDensity{}),
                                               technique_1d("linear", LinearDensity(0, 1)),
                                               technique_1d("peaked", TruncatedExponential(6))};
    return all;
}
double parabola(const Point<1>& x) {
    return 3 * x[0] * x[0];
}
const std::vector<std::uint64_t> sample_counts{1, 4, 3};
const std::vector<double> choice_probabilities{0.25, 0.5, 0.25};

template <class Heuristic>
Draw multi_sample(Heuristic heuristic) {
    return [heuristic](RandomStream& random) {
        return mis_multi_sample<1>(parabola, techniques(), sample_counts, heuristic, random).value;
    };
}

Draw multi_sample_by(Contribution<double> contribution) {
    return [contribution](RandomStream& random) {
        const std::vector<double> n(sample_counts.begin(), sample_counts.end());
        double estimate = 0;
        for (std::size_t i = 0; i < n.size(); ++i)
            for (std::uint64_t j = 0; j < sample_counts[i]; ++j) {
                const Point<1> x = techniques()[i].sample(uniform_point<1>(random));
                estimate += contribution(i, parabola(x), n, pdfs_at<1>(x, techniques()));
            }
        return estimate;
    };
}

Draw one_sample_by(Contribution<double> contribution) {
    return [contribution](RandomStream& random) {
        const std::size_t i = DiscreteCdf<double>(choice_probabilities).sample(random);
        const Point<1> x = techniques()[i].sample(uniform_point<1>(random));
        return contribution(i, parabola(x), choice_probabilities, pdfs_at<1>(x, techniques()));
    };
}

/// The linear density is 4 % too large where its own samples are divided by it.
template <class Heuristic>
Contribution<double> linear_pdf_too_large(Heuristic heuristic) {
    return [heuristic](std::size_t i, double f, std::span<const double> n, std::span<const double> p) {
        return mis_contribution<double>(i, i == 1 ? f / 1.04 : f, heuristic, n, p);
    };
}

/// w_i/(n_i p_i) ≤ 1/max n_k p_k ≤ 1 for each of the heuristics (technique 0 is uniform with one sample), so that no
/// sample adds more than max f = 3. A mutant's value may leave these bounds: that refutes it too.
Verdict multi_sample_mean(const Draw& draw, const Run& run) {
    return mean_is(draw, {.reference = 1, .delta = 0.01, .bounds = {0, 3.0 * 8}}, run);
}

Verdict one_sample_mean(const Draw& draw, const Run& run) {
    return mean_is(draw, {.reference = 1, .delta = 0.01, .bounds = {0, 3 / 0.25}}, run);
}

/// The variance of the multi-sample estimator with the balance heuristic, by quadrature on 32 panels.
double predicted_balance_variance(const std::vector<std::uint64_t>& counts) {
    const std::vector<double> n(counts.begin(), counts.end());
    double variance = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        const auto integral = [&](int power) {
            double sum = 0;
            for (int panel = 0; panel < 32; ++panel)
                sum += boost::math::quadrature::gauss<double, 15>::integrate(
                    [&](double x) {
                        const double p = techniques()[i].pdf({x});
                        const double value =
                            mis_weights<double>(Balance{}, n, pdfs_at<1>({x}, techniques()))[i] * parabola({x});
                        return power == 1 ? value : value * value / p;
                    },
                    panel / 32.0, (panel + 1) / 32.0);
            return sum;
        };
        variance += (integral(2) - integral(1) * integral(1)) / n[i];
    }
    return variance;
}

Verdict balance_variance(const Draw& draw, const Run& run) {
    return variance_is(draw, predicted_balance_variance(sample_counts), 0.05, 60000, run,
                       "weighted values between 0 and 24");
}

std::vector<double> for_other_counts(std::span<const double> n, std::span<const double> p) {
    return mis_weights<double>(Balance{}, std::vector<double>{1.4, n[1], n[2]}, p);
}

/// E[standard_error²] is the variance, so its difference from the squared error has the mean 0.
Verdict error_bar_mean(double factor, const Run& run) {
    static const std::vector<std::uint64_t> counts{3, 3, 3};
    const Draw difference = [factor](RandomStream& random) {
        const Estimate estimate = mis_multi_sample<1>(parabola, techniques(), counts, Balance{}, random);
        const double bar = estimate.standard_error, error = estimate.value - 1;
        return factor * bar * bar - error * error;
    };
    // A sample adds f / (3 Σ p_k) ≤ 1/3. So the estimate lies in [0, 3], and with three samples a technique's variance
    // of three times that is at most 1/3: squared bar ≤ 1/3.
    return mean_is(difference,
                   {.reference = 0, .delta = 0.1 * predicted_balance_variance(counts), .bounds = {-4, 1.0 / 3}}, run);
}

void add_weights(Catalogue& catalogue) {
    catalogue.add({
        .id = "mis/weights/double-sum",
        .statement = "In double the weights sum to 1 within 2 ulp, for densities from 5e-324 to 1.7e308, infinite "
                     "ones, and a thousand techniques.",
        .source = "ours, estimators/mis/mis.h",
        .kind = Kind::bounded,
        .trial = {double_sums_to_one,
                  all_heuristics<double>(),
                  {{"balance-without-scaling", "n p is not scaled: it overflows.", {without_scaling(Balance{})}},
                   {"power-without-scaling",
                    "(n p)² is not scaled: it overflows and underflows.",
                    {without_scaling(Power{})}}}},
    });
    catalogue.add({
        .id = "mis/weights/double-error",
        .statement = "Each balance and power weight is within 16 ulp of its exact value.",
        .source = "ours: at most 8 and 16 roundings of relative size 2^-53, the common ones cancel",
        .kind = Kind::bounded,
        .trial = {[](const std::vector<PowerWeights>& all) { return all_of_each(double_weights_are_right, all); },
                  {{weights<double>(Balance{}), 1}, {weights<double>(Power{}), 2}},
                  {{"power-without-scaling",
                    "(n p)² is not scaled: it overflows and underflows.",
                    {{without_scaling(Power{}), 2}}}}},
    });
}

void add_mean(Catalogue& catalogue, const std::string& name, const Draw& right, std::vector<Wrong<Draw>> wrong) {
    catalogue.add({
        .id = fmt::format("mis/{}/mean", name),
        .statement = fmt::format("Multi-sample MIS with the {} heuristic has the mean ∫f.", name),
        .source = "[Veach 1997, lemma 9.1]",
        .kind = Kind::mean,
        .trial = {multi_sample_mean, right, std::move(wrong)},
    });
}

template <class Heuristic>
Wrong<Draw> pdf_off_by_normalisation(Heuristic heuristic) {
    return {"pdf-off-by-normalisation", "The linear density is 4 % too large where its own samples are divided by it.",
            multi_sample_by(linear_pdf_too_large(heuristic))};
}

template <class Heuristic>
Draw over_the_balance_sum_of(Heuristic heuristic) {
    return multi_sample_by(with_weights<double>(over_the_balance_sum<double>(heuristic)));
}

void add_means(Catalogue& catalogue) {
    add_mean(catalogue, "balance", multi_sample(Balance{}),
             {{"short-form-wrong-counts", "f / Σ n_k p_k takes the counts in another order.",
               multi_sample_by(short_form_with_reversed_counts<double>)},
              pdf_off_by_normalisation(Balance{})});
    add_mean(catalogue, "power", multi_sample(Power{}),
             {pdf_off_by_normalisation(Power{}),
              {"not-normalised", "Squares are divided by the sum of n p.", over_the_balance_sum_of(Power{})}});
    add_mean(catalogue, "maximum", multi_sample(Maximum{}),
             {pdf_off_by_normalisation(Maximum{}),
              {"not-normalised", "The largest technique keeps its balance weight, the others lose theirs.",
               over_the_balance_sum_of(Maximum{})}});
    add_mean(catalogue, "cutoff", multi_sample(Cutoff{0.2}),
             {pdf_off_by_normalisation(Cutoff{0.2}),
              {"not-renormalised", "What is cut off is not given to the techniques that stay.",
               over_the_balance_sum_of(Cutoff{0.2})}});
    catalogue.add({
        .id = "mis/one-sample/mean",
        .statement = "One-sample MIS has the mean ∫f.",
        .source = "[Veach 1997, eq. 9.15]",
        .kind = Kind::mean,
        .trial = {one_sample_mean,
                  [](RandomStream& random) {
                      return mis_one_sample<1>(parabola, techniques(), choice_probabilities, Balance{}, 1, random)
                          .value;
                  },
                  {{"without-c", "The value is not divided by the probability of the technique.",
                    one_sample_by(without_c<double>)},
                   {"pdf-off-by-normalisation",
                    "The linear density is 4 % too large where its own samples are divided by it.",
                    one_sample_by(linear_pdf_too_large(Balance{}))}}},
    });
}

void add_variances(Catalogue& catalogue) {
    catalogue.add({
        .id = "mis/balance/variance",
        .statement = "The variance of multi-sample MIS is Σ_i (∫(w_i f)²/p_i − (∫w_i f)²)/n_i.",
        .source = "[Veach 1997, appendix 9.A]",
        .kind = Kind::ratio,
        .trial = {balance_variance,
                  multi_sample(Balance{}),
                  {{"counts-off", "The weights are for counts 1.4, 4, 3: unbiased, but of another variance.",
                    multi_sample_by(with_weights<double>(for_other_counts))},
                   {"wrong-counts", "The weights take every count for 1: unbiased, but of another variance.",
                    multi_sample_by(with_weights<double>(ignoring_counts<double>()))}}},
    });
    catalogue.add({
        .id = "mis/balance/error-bar",
        .statement = "The squared standard error of multi-sample MIS is on average its variance.",
        .source = "ours, estimators/mis/mis_estimators.h",
        .kind = Kind::mean,
        .trial = {error_bar_mean,
                  1,
                  {{"variance-over-n", "Sums of squares are divided by n = 3, not by n − 1.", 2.0 / 3}}},
    });
}

}  // namespace

void add_mis_mis(Catalogue& catalogue) {
    add_weights(catalogue);
    add_means(catalogue);
    add_variances(catalogue);
}

}  // namespace plumb::suites
