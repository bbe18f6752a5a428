// Importance sampling and control variates: means, known variances, the bias of a coefficient fitted on the samples
// that it is applied to, error bars.

#include <cmath>

#include "analytic/enumeration.h"
#include "estimators/densities/density.h"
#include "estimators/mis/control_variate.h"
#include "estimators/mis/importance_estimators.h"
#include "estimators/mis/importance_sampling.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"
#include "verification/evidence/ratio.h"

namespace plumb::suites {
namespace {

double exponential(const Point<1>& x) {
    return std::exp(x[0]);
}
const double e = std::exp(1.0);

// ---- importance sampling of e^x, with the density 1/2 + x unless a mutant has another

Draw importance(const Technique<1>& technique) {
    return
        [technique](RandomStream& random) { return importance_sampling<1>(exponential, technique, 1, random).value; };
}
Technique<1> linear() {
    return technique_1d("linear", LinearDensity(1, 3));
}
Technique<1> linear_off_by(double factor) {
    return {"off", linear().sample, [factor](const Point<1>& x) { return linear().pdf(x) * factor; }};
}

/// e^x / (1/2 + x) has its minimum √e at x = 1/2 and its maximum 2 at x = 0.
Verdict importance_mean(const Technique<1>& technique, const Run& run) {
    return mean_is(importance(technique), {.reference = e - 1, .delta = 0.003, .bounds = {std::sqrt(e), 2}}, run);
}

Verdict perfect_importance(const Technique<1>& technique, const Run& run) {
    const Draw draw = [technique](RandomStream& random) {
        return importance_sampling<1>([](const Point<1>& x) { return 1 + 2 * x[0]; }, technique, 1, random).value;
    };
    return mean_is(draw, {.reference = 2, .epsilon = 1e-15, .zero_variance = true}, run);
}

Verdict importance_error_bar(double factor, const Run& run) {
    const Draw difference = [factor](RandomStream& random) {
        const Estimate estimate = importance_sampling<1>(exponential, linear(), 3, random);
        const double bar = estimate.standard_error, error = estimate.value - (e - 1);
        return factor * bar * bar - error * error;
    };
    // Values lie in [√e, 2]: three of them have a variance of at most (2 − √e)²/3, and their mean errs by at most
    // 2 − (e − 1). Their variance is ∫ e^2x/(1/2 + x) − (e − 1)² = 0.0047; the mutant's bias is a ninth of it.
    const double widest = 2 - std::sqrt(e), worst = 3 - e;
    return mean_is(difference, {.reference = 0, .delta = 2e-4, .bounds = {-worst * worst, widest * widest / 9}}, run);
}

// ---- control variates of e^x by x, ∫x = 1/2

const ControlVariate<1> identity{[](const Point<1>& x) { return x[0]; }, 0.5};
/// Cov(e^U, U) = (3 − e)/2, Var U = 1/12.
const double best_beta = 6 * (3 - e);
/// Var e^U − Cov²/Var U.
const double best_variance = (e * e - 1) / 2 - (e - 1) * (e - 1) - 3 * (3 - e) * (3 - e);

Draw controlled(double beta, const ControlVariate<1>& g) {
    return [beta, g](RandomStream& random) { return control_variate<1>(exponential, g, beta, 1, random).value; };
}

/// e^x − β (x − 1/2) is convex, with its minimum at x = ln β and its maximum at x = 1.
Verdict control_variate_mean(const ControlVariate<1>& g, const Run& run) {
    const double least = best_beta * (1.5 - std::log(best_beta));
    return mean_is(controlled(best_beta, g), {.reference = e - 1, .delta = 0.002, .bounds = {least, e - best_beta / 2}},
                   run);
}

// ---- the fitted coefficient

template <class T>
using Values = std::function<std::vector<T>(const std::vector<Pair<T>>& samples, const T& integral_g)>;

template <class T>
std::vector<T> cross_fitted(const std::vector<Pair<T>>& samples, const T& integral_g) {
    return cross_fitted_values(samples, integral_g, 4);
}
template <class T>
std::vector<T> fitted_on_the_same(const std::vector<Pair<T>>& samples, const T& integral_g) {
    const T beta = fitted_coefficient(samples, [](std::size_t) { return true; });
    std::vector<T> values;
    for (const Pair<T>& sample : samples) values.push_back(sample.f - beta * (sample.g - integral_g));
    return values;
}

/// f and g on a domain of three equally likely points, every outcome of n samples: mean f = 8/3.
Verdict fitted_enumerated(const Values<Rational>& values) {
    const std::vector<Pair<Rational>> domain{{1, 0}, {2, 1}, {5, 3}};
    std::uint64_t outcomes = 0;
    for (const std::size_t n : {1u, 2u, 3u, 5u}) {
        const ExactMoments exact = enumerate([&](Choices& random) {
            std::vector<Pair<Rational>> samples(n);
            for (auto& sample : samples) sample = domain[random.below(3)];
            Rational sum = 0;
            for (const Rational& value : values(samples, Rational(4, 3))) sum += value;
            return Rational(sum / n);
        });
        outcomes += exact.outcomes;
        if (exact.mean != Rational(8, 3))
            return exactly(false, outcomes, fmt::format("n = {}: mean {} for 8/3", n, exact.mean.str()));
    }
    return exactly(true, outcomes, "every mean is that of f");
}

/// x² with the control variate x and 4 samples. Slopes between points of x² lie in [0, 2], and so do fitted ones:
/// values lie in [−1, 2].
Verdict fitted_mean(const Values<double>& values, const Run& run) {
    const Draw draw = [values](RandomStream& random) {
        std::vector<Pair<double>> samples(4);
        for (Pair<double>& sample : samples) {
            sample.g = random.uniform();
            sample.f = sample.g * sample.g;
        }
        double sum = 0;
        for (const double value : values(samples, 0.5)) sum += value;
        return sum / 4;
    };
    return mean_is(draw, {.reference = 1.0 / 3, .delta = 0.005, .bounds = {-1, 2}}, run);
}

/// With fitted β the variance tends to best_variance/n; at n = 256 it is within a few percent of it.
Verdict fitted_variance(std::size_t n, const Run& run) {
    const Draw draw = [n](RandomStream& random) {
        return control_variate_fitted<1>(exponential, identity, n, random).value;
    };
    return variance_is(draw, best_variance / 256, 0.1, 10000, run, "means of values between 1 and e");
}

// ---- the registered estimators on e^x and e^(x+y)
//
// None leaves [0, 3 max f]: a third of all samples is uniform, so that w_i/(n_i p_i) ≤ 3/n and w_i/(c_i p_i) ≤ 3; the
// densities of importance-linear are ≥ 1/2; fitted slopes lie between those of f.

template <int D>
void add_registered(Catalogue& catalogue, const std::vector<Estimator<D>>& estimators) {
    for (const Estimator<D>& estimator : estimators) {
        const auto mean = [estimator](double scale, const Run& run) {
            const Function<D> f = [](const Point<D>& x) { return std::exp(x[0] + (D == 2 ? x[D - 1] : 0)); };
            const double reference = D == 1 ? e - 1 : (e - 1) * (e - 1);
            const Draw draw = [&](RandomStream& random) { return scale * estimator.run(f, 6, random).value; };
            const double most = 3 * (D == 1 ? e : e * e);
            return mean_is(draw, {.reference = reference, .delta = 0.01 * reference, .bounds = {0, most}}, run);
        };
        catalogue.add({
            .id = fmt::format("importance/{}/mean-{}d", estimator.id, D),
            .statement = fmt::format("`{}` has the mean of e to the sum of the coordinates with 6 samples in {}D.",
                                     estimator.id, D),
            .source = estimator.source,
            .kind = Kind::mean,
            .trial = {mean, 1, {{"three-percent", "A density or weight is off by a normalisation of 3 %.", 1.03}}},
        });
    }
}

void add_importance(Catalogue& catalogue) {
    catalogue.add({
        .id = "importance/linear/mean",
        .statement = "f(X)/p(X) has the mean ∫f.",
        .source = "[Kahn & Marshall 1953]",
        .kind = Kind::mean,
        .trial = {importance_mean,
                  linear(),
                  {{"pdf-off-by-normalisation", "The pdf is 0.5 % too large.", linear_off_by(1.005)},
                   {"pdf-squared",
                    "Divided by the square of the pdf.",
                    {"squared", linear().sample, [](const Point<1>& x) { return std::pow(linear().pdf(x), 2); }}}}},
    });
    catalogue.add({
        .id = "importance/perfect/zero-variance",
        .statement = "A density proportional to f gives ∫f in every sample.",
        .source = "[Kahn & Marshall 1953]",
        .kind = Kind::mean,
        .trial = {perfect_importance,
                  linear(),
                  {{"almost-proportional", "The density rises from 1 to 3.0001.",
                    technique_1d("almost", LinearDensity(1, 3.0001))}}},
    });
    catalogue.add({
        .id = "importance/linear/error-bar",
        .statement = "The squared standard error of importance sampling is on average its variance.",
        .source = "ours, estimators/mis/importance_sampling.h",
        .kind = Kind::mean,
        .trial = {importance_error_bar,
                  1,
                  {{"variance-over-n", "The sum of squares is divided by n = 3, not by n − 1.", 2.0 / 3}}},
    });
}

void add_control_variates(Catalogue& catalogue) {
    catalogue.add({
        .id = "control-variate/known/mean",
        .statement = "f − β (g − ∫g) has the mean ∫f.",
        .source = "[Hammersley & Handscomb 1964, section 5.5]",
        .kind = Kind::mean,
        .trial = {control_variate_mean,
                  identity,
                  {{"wrong-integral", "∫g is 0.503, not 1/2.", {identity.value, 0.503}}}},
    });
    catalogue.add({
        .id = "control-variate/known/variance",
        .statement = "With β = Cov(f,g)/Var g the variance is Var f − Cov²/Var g.",
        .source = "[Hammersley & Handscomb 1964, section 5.5]",
        .kind = Kind::ratio,
        .trial = {[](double beta, const Run& run) {
                      return variance_is(controlled(beta, identity), best_variance, 0.05, 40000, run,
                                         "values between 1 and 3");
                  },
                  best_beta,
                  {{"another-coefficient", "β is 5 % too small.", 0.95 * best_beta}}},
    });
    catalogue.add({
        .id = "control-variate/fitted/expectation",
        .statement = "With the coefficient fitted on other folds the expectation over every outcome is that of f, for "
                     "every n.",
        .source = "ours, estimators/mis/control_variate.h",
        .kind = Kind::exact,
        .trial = {fitted_enumerated,
                  cross_fitted<Rational>,
                  {{"same-samples", "The coefficient is fitted on the samples that it is applied to.",
                    fitted_on_the_same<Rational>}}},
    });
    catalogue.add({
        .id = "control-variate/fitted/mean",
        .statement = "The cross-fitted control variate is unbiased with 4 samples.",
        .source = "ours, estimators/mis/control_variate.h",
        .kind = Kind::mean,
        .trial = {fitted_mean,
                  cross_fitted<double>,
                  {{"same-samples", "The coefficient is fitted on the samples that it is applied to.",
                    fitted_on_the_same<double>}}},
    });
    catalogue.add({
        .id = "control-variate/fitted/variance",
        .statement = "With 256 samples the cross-fitted control variate has the best coefficient's variance within "
                     "10 %.",
        .source = "ours, estimators/mis/control_variate.h",
        .kind = Kind::ratio,
        .trial = {fitted_variance, 256, {{"samples-left-out", "Each estimate uses 200 of its 256 samples only.", 200}}},
    });
}

}  // namespace

void add_mis_variance_reduction(Catalogue& catalogue) {
    add_importance(catalogue);
    add_control_variates(catalogue);
    add_registered(catalogue, importance_estimators_1d());
    add_registered(catalogue, importance_estimators_2d());
}

}  // namespace plumb::suites
