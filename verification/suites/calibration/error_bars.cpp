// The error bars of the shipped estimators on trial: every one that reports a standard error from a single run, and
// replicated() for those that cannot.

#include <cmath>
#include <numbers>

#include "analytic/integrand.h"
#include "estimators/estimator.h"
#include "estimators/replicates/replicates.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"

namespace plumb::suites {
namespace {

constexpr double student_t_127_at_975 = 1.9788195347, normal_at_975 = 1.9599639845400543;

// The standard errors of n = 256 bounded values: coverage differs from 95 % by O(1/n) and by the skewness of the values
// over sqrt(n) squared; epsilon leaves room for both.
Verdict covers(const std::function<Estimate(RandomStream&)>& estimate, double truth, double quantile, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        const Estimate found = estimate(random);
        return std::abs(found.value - truth) <= quantile * found.standard_error ? 1.0 : 0.0;
    };
    const double delta = run.pick(0.02, 0.01);
    return mean_is(draw, {.reference = 0.95, .delta = delta, .epsilon = 0.005, .bounds = {0, 1}}, run);
}

template <int D>
void add_claim(Catalogue& catalogue, const std::string& estimator, const std::string& integrand_id) {
    const auto estimate = [=](RandomStream& random) {
        return find_estimator<D>(estimator).run(find_integrand<D>(integrand_id).value, 256, random);
    };
    const auto check = [=](double quantile, const Run& run) {
        return covers(estimate, find_integrand<D>(integrand_id).integral_value(), quantile, run);
    };
    catalogue.add(
        {.id = fmt::format("calibration/error-bars/{}-{}d", estimator, D),
         .statement = fmt::format("The value of `{}` lies within 1.96 reported standard errors of the integral of `{}` "
                                  "in 95 % of the runs.",
                                  estimator, integrand_id),
         .source = "central limit theorem; docs/statistics.md, Error bars",
         .kind = Kind::mean,
         .trial = {check,
                   normal_at_975,
                   {{"four-fifths", "the reported standard error is a fifth too small: 88 %", 0.8 * normal_at_975}}},
         .sizes = D == 1 ? Sizes::both : Sizes::full_only});
}

template <int D>
void add_replicated_claim(Catalogue& catalogue, const std::string& estimator, const std::string& integrand_id) {
    const auto check = [=](double quantile, const Run& run) {
        const Integrand<D>& f = find_integrand<D>(integrand_id);
        const auto estimate = [&](RandomStream& random) {
            return replicated<D>(find_estimator<D>(estimator).run, f.value, 8, 128, random);
        };
        return covers(estimate, f.integral_value(), quantile, run);
    };
    catalogue.add({.id = fmt::format("calibration/error-bars/replicated-{}-{}d", estimator, D),
                   .statement = fmt::format("128 replicates of `{}` cover the integral of `{}` in 95 % of the runs.",
                                            estimator, integrand_id),
                   .source = "[Student 1908]; docs/statistics.md, Error bars",
                   .kind = Kind::mean,
                   .trial = {check,
                             student_t_127_at_975,
                             {{"four-fifths", "the standard error is a fifth too small", 0.8 * student_t_127_at_975}}},
                   .sizes = Sizes::full_only});
}

}  // namespace

void add_calibration_error_bars(Catalogue& catalogue) {
    for (const auto* id : {"independent", "importance-linear", "mis-balance", "mis-power", "mis-one-sample",
                           "control-variate-fitted", "roulette"}) {
        add_claim<1>(catalogue, id, "exp");
        add_claim<2>(catalogue, id, "exp-sum");
    }
    for (const auto* id : {"stratified", "sobol-owen", "hammersley-shifted", "torus-tent"})
        add_replicated_claim<1>(catalogue, id, "exp");
    for (const auto* id : {"latin-hypercube", "cmj"}) add_replicated_claim<2>(catalogue, id, "exp-sum");
}

}  // namespace plumb::suites
