// Slopes on trial: what is no power law, and tails that leave an interval worthless.

#include <cmath>

#include "core/moments.h"
#include "verification/claim.h"
#include "verification/evidence/distributions.h"
#include "verification/evidence/log_mean.h"
#include "verification/evidence/mean.h"
#include "verification/evidence/rate.h"
#include "verification/evidence/ratio.h"
#include "verification/suites/calibration/laws.h"

namespace plumb::suites {
namespace {

// The share of runs in which something happens.
Verdict share_is(const std::function<bool(RandomStream&)>& happens, double rate, const Run& run) {
    const auto cap = run.pick<std::uint64_t>(4096, 1 << 17);
    const auto draw = [&](RandomStream& random) { return happens(random) ? 1.0 : 0.0; };
    return mean_at_most(draw, {.bound = rate, .margin = rate / 2, .bounds = {0, 1}, .cap = cap}, run);
}

// ---- no power law ----

// The MSE of normal errors at n.
struct Course {
    std::string id, what;
    std::function<double(double n)> mse;
    Interval claimed;
};

using RateTest = std::function<Verdict(const Replicate&, const ConvergenceSetting&, const Interval&, const Run&)>;

// What a slope says of itself, whatever it was fitted to.
Verdict slope_alone(const Replicate& replicate, const ConvergenceSetting& setting, const Interval& exponents,
                    const Run& run) {
    const LogMean slope = fitted_exponent(measure_convergence(replicate, setting, run).points);
    const double half = normal_upper_quantile(beta_in_use / 2) * slope.standard_error;
    Verdict verdict;
    if (Interval{slope.value - half, slope.value + half}.inside(exponents)) verdict.outcome = Outcome::holds;
    return verdict;
}

struct TestOfRates {
    RateTest test;
};

bool holds(const Course& course, const RateTest& test, RandomStream& random) {
    const Replicate replicate = [&](std::uint64_t n, RandomStream& own) {
        return Estimate{std::sqrt(course.mse(static_cast<double>(n))) * normal().draw(0, own).x, 0, n};
    };
    const ConvergenceSetting setting{
        .estimator = "simulated", .integrand = "", .n = {16, 64, 256, 1024, 4096}, .replicates = 200};
    return test(replicate, setting, course.claimed, Run(random.bits(), "inner", alpha_in_use)).outcome ==
           Outcome::holds;
}

void add_courses(Catalogue& catalogue) {
    const std::vector<Course> courses{{"bent",
                                       "falls as n^-2 until 256 and then no more",
                                       [](double n) { return std::pow(std::min(n, 256.0), -2); },
                                       {-1.4, -0.6}},
                                      {"stalled",
                                       "falls as n^-2 but not from the last count but one",
                                       [](double n) { return std::pow(std::min(n, 1024.0), -2); },
                                       {-2.3, -1.5}},
                                      {"stepped",
                                       "falls as n^-1 but for a step to its eightfold",
                                       [](double n) { return (n > 256 ? 8 : 1) / n; },
                                       {-0.8, -0.2}}};
    for (const Course& course : courses)
        catalogue.add(
            {.id = "calibration/fit/" + course.id,
             .statement = fmt::format("An MSE that {} holds as a power law in at most 1 % of the runs.", course.what),
             .source = "docs/statistics.md, Rates and ratios",
             .kind = Kind::mean,
             .trial = {[course](const TestOfRates& subject, const Run& run) {
                           return share_is([&](RandomStream& random) { return holds(course, subject.test, random); },
                                           beta_in_use, run);
                       },
                       TestOfRates{rate_is},
                       {{"slope-alone", "The slope's interval alone is looked at.", TestOfRates{slope_alone}}}},
             .sizes = course.id == "bent" ? Sizes::both : Sizes::full_only});
}

// ---- tails ----

// What interval of a slope is shown, if any.
struct Shown {
    std::function<Interval(const std::vector<ConvergencePoint>&)> interval;
};

Interval shown_by_fit(const std::vector<ConvergencePoint>& points) {
    return fit_slope(points, 0.99).interval;
}
Interval of_errors_alone(const std::vector<ConvergencePoint>& points) {
    const LogMean slope = fitted_exponent(points);
    const double half = normal_upper_quantile(0.005) * slope.standard_error;
    return {slope.value - half, slope.value + half};
}

// Means of n values of lognormal(1.5), whose MSE goes as 1/n: few of 100 runs carry it, the fewer the smaller n is.
Verdict interval_covers(const Shown& shown, const Run& run) {
    const TiltedLaw law = lognormal(1.5);
    const auto replicate = [law](std::uint64_t n, RandomStream& random) {
        double sum = 0;
        for (std::uint64_t i = 0; i < n; ++i) sum += law.draw(0, random).x;
        return Estimate{sum / static_cast<double>(n), 0, n};
    };
    const auto misses = [&](RandomStream& random) {
        const ConvergenceSetting setting{
            .estimator = "simulated", .integrand = "", .truth = law.mean, .n = {4, 16, 64}, .replicates = 100};
        const Series series = measure_convergence(replicate, setting, Run(random.bits(), "inner", alpha_in_use));
        return !shown.interval(series.points).contains(-1);
    };
    return share_is(misses, 0.02, run);
}

constexpr std::uint64_t few = 1000;

using VarianceTest = std::function<Verdict(const Draw&, double variance, double delta, const Run&)>;
struct TestOfVariances {
    VarianceTest test;
};

Verdict by_kurtosis_alone(const Draw& draw, double variance, double, const Run& run) {
    Moments moments;
    for (std::uint64_t i = 0; i < few; ++i) {
        RandomStream random = run.random(i);
        moments.add(draw(random));
    }
    const double error = std::sqrt((moments.kurtosis() - 1) / static_cast<double>(few));
    Verdict verdict;
    if (error <= largest_log_error &&
        std::abs(std::log(moments.variance() / variance)) > normal_upper_quantile(alpha_in_use / 2) * error)
        verdict.outcome = Outcome::refuted;
    return verdict;
}

Verdict shipped_variance(const Draw& draw, double variance, double delta, const Run& run) {
    return variance_is(draw, variance, delta, few, run, "as many as its rival has");
}

Verdict heavy_variance_stands(const TestOfVariances& subject, const Run& run) {
    const TiltedLaw law = lognormal(2);
    const auto refuted = [&](RandomStream& random) {
        const auto draw = [&](RandomStream& own) { return law.draw(0, own).x; };
        return subject.test(draw, law.sigma * law.sigma, 0.2, Run(random.bits(), "inner", alpha_in_use)).outcome ==
               Outcome::refuted;
    };
    return share_is(refuted, 0.02, run);
}

}  // namespace

void add_calibration_fits(Catalogue& catalogue) {
    add_courses(catalogue);
    catalogue.add(
        {.id = "calibration/coverage/slope-of-spikes",
         .statement =
             "A 99 % interval that is shown for a slope from 100 runs of lognormal(1.5) values misses the truth in "
             "at most 2 % of the runs.",
         .source = "docs/statistics.md, Rates and ratios",
         .kind = Kind::mean,
         .trial = {interval_covers,
                   Shown{shown_by_fit},
                   {{"errors-alone", "The points' errors by the delta method are believed whatever the tails.",
                     Shown{of_errors_alone}}}}});
    catalogue.add(
        {.id = "calibration/heavy-tails/variance",
         .statement = "The true variance of lognormal(2) values is refuted by 1,000 in at most 2 % of the runs.",
         .source = "docs/statistics.md, Rates and ratios",
         .kind = Kind::mean,
         .trial = {heavy_variance_stands,
                   TestOfVariances{shipped_variance},
                   {{"kurtosis-alone", "The error by the sample's kurtosis is believed.",
                     TestOfVariances{by_kurtosis_alone}}}},
         .sizes = Sizes::full_only});
}

}  // namespace plumb::suites
