// The tests of a fixed size on trial that rest on a normal approximation: slopes and ratios of variances.

#include <cmath>

#include "verification/claim.h"
#include "verification/evidence/distribution.h"
#include "verification/evidence/distributions.h"
#include "verification/evidence/mean.h"
#include "verification/evidence/rate.h"
#include "verification/evidence/ratio.h"
#include "verification/suites/calibration/laws.h"

namespace plumb::suites {
namespace {

constexpr double level = 0.01;

// Errors of standard deviation 1/n that are uniform or normal: MSE n^-2.
Replicate errors_of(const TiltedLaw& law) {
    return [law](std::uint64_t n, RandomStream& random) {
        return Estimate{(law.draw(0, random).x - law.mean) / law.sigma / static_cast<double>(n), 0, n};
    };
}

Verdict rate_verdict(const Replicate& replicate, double exponent, double alpha, std::uint64_t replicates,
                     RandomStream& random) {
    const ConvergenceSetting setting{
        .estimator = "simulated", .integrand = "", .n = {16, 64, 256}, .replicates = replicates};
    return rate_is(replicate, setting, {exponent, exponent}, Run(random.bits(), "inner", alpha));
}

// The verdict on how often a whole simulated test at this level refutes what is true.
Verdict misses(const std::function<Verdict(double alpha, RandomStream&)>& test, double alpha, double rate,
               const Run& run) {
    const auto draw = [&](RandomStream& random) { return test(alpha, random).outcome == Outcome::refuted ? 1.0 : 0.0; };
    return mean_at_most(draw, {.bound = rate, .margin = rate / 4, .bounds = {0, 1}}, run);
}

using FixedTest = std::function<Verdict(double alpha, RandomStream&)>;

void add_coverage_claim(Catalogue& catalogue, const std::string& id, const std::string& what, const FixedTest& test,
                        double rate, Sizes sizes) {
    catalogue.add({.id = "calibration/coverage/" + id,
                   .statement = fmt::format("The 99 % interval of {} misses the truth in at most {:g} % of the runs.",
                                            what, 100 * rate),
                   .source = "delta method; docs/statistics.md, Rates and ratios",
                   .kind = Kind::mean,
                   .trial = {[=](double alpha, const Run& run) { return misses(test, alpha, rate, run); },
                             level,
                             {{"interval-95", "the 95 % interval called a 99 % one", 5 * level}}},
                   .sizes = sizes});
}

// The verdict on whether z = (slope − truth)/standard error is normal: its two-sided p-value then falls evenly into ten
// cells.
Verdict slope_p_values_are_uniform(double error_factor, const Run& run) {
    const Replicate replicate = errors_of(normal());
    const auto draw = [&](RandomStream& random) {
        const Verdict verdict = rate_verdict(replicate, -2, level, 300, random);
        const Slope& slope = verdict.series.front().slope;
        const double p = normal_two_sided_tail((slope.value + 2) / (error_factor * slope.standard_error));
        return equal_cell(std::min(p, std::nextafter(1.0, 0.0)), 10);
    };
    return distribution_is(draw, {std::vector<double>(10, 0.1), 0.1}, run);
}

}  // namespace

void add_calibration_slopes(Catalogue& catalogue) {
    const auto slope_of = [](const TiltedLaw& law) {
        return [replicate = errors_of(law)](double alpha, RandomStream& random) {
            return rate_verdict(replicate, -2, alpha, 1000, random);
        };
    };
    add_coverage_claim(catalogue, "slope", "a slope from 1000 replicates of the errors of a biased coin",
                       slope_of(bernoulli(0.4)), 0.015, Sizes::both);
    add_coverage_claim(catalogue, "slope-normal", "a slope from 1000 replicates of normal errors", slope_of(normal()),
                       0.015, Sizes::full_only);
    add_coverage_claim(catalogue, "slope-exponential", "a slope from 1000 replicates of exponential errors",
                       slope_of(exponential()), 0.02, Sizes::full_only);
    const auto values = [](const TiltedLaw& law) {
        return [law](RandomStream& random) { return law.draw(0, random).x; };
    };
    const FixedTest ratio = [=](double alpha, RandomStream& random) {
        const RatioClaim claim{.ratio = {1, 1}, .replicates = 2000};
        return ratio_is(values(normal()), values(exponential()), claim, Run(random.bits(), "inner", alpha));
    };
    add_coverage_claim(catalogue, "ratio", "the ratio of a normal to an exponential variance, 2000 replicates of each,",
                       ratio, 0.015, Sizes::full_only);
    catalogue.add({.id = "calibration/p-values/slope",
                   .statement = "The p-value of a true slope is uniform over ten cells, to 10 % in phi.",
                   .source = "delta method; docs/statistics.md, Rates and ratios",
                   .kind = Kind::distribution,
                   .trial = {slope_p_values_are_uniform,
                             1,
                             {{"error-a-fifth-small", "the slope's standard error is a fifth too small", 0.8}}},
                   .sizes = Sizes::full_only});
}

}  // namespace plumb::suites
