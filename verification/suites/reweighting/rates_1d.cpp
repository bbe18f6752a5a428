#include <cmath>
#include <numbers>

#include "estimators/reweighting/cells_1d.h"
#include "estimators/reweighting/reweighting_1d.h"
#include "estimators/reweighting/reweighting_estimators_1d.h"
#include "estimators/reweighting/samples_1d.h"
#include "estimators/reweighting/tent.h"
#include "verification/claim.h"
#include "verification/evidence/rate.h"

namespace plumb::suites {
namespace {

using Samples = std::vector<double>;
using Subject = std::function<Estimate(const Function<1>&, std::uint64_t n, RandomStream&)>;

struct Problem {
    std::string id;
    Function<1> f;
    double integral;
};

// The edge of step and kink lies at an irrational place.
constexpr double edge = std::numbers::inv_pi;
const Problem exponential{"exp", [](const Point<1>& x) { return std::exp(x[0]); }, std::numbers::e - 1};
const Problem periodic{"exp(cos 2πx)",
                       [](const Point<1>& x) { return std::exp(std::cos(2 * std::numbers::pi * x[0])); },
                       1.26606587775200833559824462521};  // the Bessel function I_0(1)
const Problem step{"step at 1/π", [](const Point<1>& x) { return x[0] < edge ? 1.0 : 0.0; }, edge};
const Problem periodic_kink{"|φ(x) − 1/π|", [](const Point<1>& x) { return std::abs(tent(x[0]) - edge); },
                            (edge * edge + (1 - edge) * (1 - edge)) / 2};

Subject shipped(std::string_view id) {
    for (const Estimator<1>& estimator : reweighting_estimators_1d())
        if (estimator.id == id) return estimator.run;
    throw std::logic_error("no such estimator");
}

Subject weighted(Samples (*draw)(std::uint64_t, RandomStream&), Samples (*weigh)(std::span<const double>)) {
    return [=](const Function<1>& f, std::uint64_t n, RandomStream& random) {
        const Samples samples = draw(n, random), weights = weigh(samples);
        Estimate estimate{.evaluations = n};
        for (std::size_t i = 0; i < samples.size(); ++i) estimate.value += weights[i] * f({samples[i]});
        return estimate;
    };
}

Samples equal_weights(std::span<const double> samples) {
    return Samples(samples.size(), 1 / static_cast<double>(samples.size()));
}

const Subject monte_carlo = weighted(independent_samples_1d, equal_weights);
const Subject stratified = weighted(jittered_samples_1d, equal_weights);

// u ↦ 2u mod 1 covers [0,1] twice as the tent does, but jumps from f(1) to f(0) twice.
Subject sawtooth(const Subject& subject) {
    return [=](const Function<1>& f, std::uint64_t n, RandomStream& random) {
        return subject([&f](const Point<1>& u) { return f({u[0] < 0.5 ? 2 * u[0] : 2 * u[0] - 1}); }, n, random);
    };
}

// Where theory's exponent is reached, and by how many replicates.
//
// An error that falls like N^-4 comes from the one or two cells at a kink or an end and goes like the square of their
// length, E²/N² with E about exponential: the squared errors have a kurtosis of about 70, and a single replicate with
// E > (8 R)^{1/4} makes a quarter of their sum, which leaves the slope undecided. R = 30,000 (E > 22) makes that rarer
// than 1e-5 where R = 3,000 (E > 12) does not. Errors of N^-2 go like E itself, and jittered samples have bounded
// cells.
struct Range {
    std::vector<std::uint64_t> n;
    std::uint64_t replicates;
};
const Range light_tails{{16, 32, 64, 128, 256}, 2000};
const Range heavy_tails{{32, 64, 128, 256}, 30000};
// Mutants are off by a whole power of N and more: that shows early.
const Range mutant_range{{16, 32, 64, 128, 256}, 1000};

Verdict slope_is(double exponent, double margin, const Subject& subject, const Problem& problem, const Range& range,
                 const Run& run, const std::string& name) {
    return rate_is([&](std::uint64_t n, RandomStream& random) { return subject(problem.f, n, random); },
                   {.estimator = name,
                    .integrand = problem.id,
                    .truth = problem.integral,
                    .n = range.n,
                    .replicates = range.replicates},
                   {exponent - margin, exponent + margin}, run);
}

struct RateClaim {
    std::string id, statement, source, estimator;
    double exponent, margin;
    Problem problem;
    Range range;
    Subject subject = {};  ///< the shipped estimator where empty
    Sizes sizes = Sizes::both;
};

// What is measured, by how many replicates, and its name in the report.
struct Measured {
    std::string name;
    Subject subject;
    Range range;
};

struct RateMutant {
    std::string id, defect;
    Subject subject;
};

void add(Catalogue& catalogue, RateClaim claim, const std::vector<RateMutant>& mutants) {
    if (!claim.subject) claim.subject = shipped(claim.estimator);
    std::vector<Wrong<Measured>> wrong;
    for (const auto& [id, defect, subject] : mutants) wrong.push_back({id, defect, {id, subject, mutant_range}});
    catalogue.add({.id = claim.id,
                   .statement = claim.statement,
                   .source = claim.source,
                   .kind = Kind::rate,
                   .trial = {[claim](const Measured& measured, const Run& run) {
                                 return slope_is(claim.exponent, claim.margin, measured.subject, claim.problem,
                                                 measured.range, run, measured.name);
                             },
                             {claim.estimator, claim.subject, claim.range},
                             std::move(wrong)},
                   .sizes = claim.sizes});
}

void add_slow(Catalogue& catalogue) {
    add(catalogue,
        {"reweighting/monte-carlo/rate", "The MSE of independent samples with equal weights falls like N^-1.",
         "ours, docs/statistics.md", "monte-carlo", -1, 0.2, exponential, light_tails, monte_carlo},
        {{"stratified-in-disguise", "samples that are not independent: one a stratum", stratified}});
    add(catalogue,
        {"reweighting/reweighted/rate",
         "The MSE of the unbiased reweighted estimator falls only like N^-2 where f(0), f(1) ≠ 0, not like N^-4.",
         "ours, estimators/reweighting/reweighting_1d.h; against [thesis, section 4.5.1]",
         "reweighted",
         -2,
         0.25,
         exponential,
         {light_tails.n, 5000}},
        {{"rate-as-printed", "the estimator of Yakowitz et al., whose rate N^-4 is printed for it",
          shipped("yakowitz-trapezoid")},
         {"equal-weights", "weights 1/N", monte_carlo}});
    add(catalogue,
        {"reweighting/torus/rate", "The MSE of cells on the circle falls like N^-2 where f(0) ≠ f(1).",
         "ours, docs/statistics.md", "torus", -2, 0.25, exponential, light_tails},
        {{"equal-weights", "weights 1/N", monte_carlo}});
    add(catalogue,
        {"reweighting/torus/rate-of-a-jump", "The MSE of cells on the circle falls like N^-2 for a jump inside.",
         "ours, docs/statistics.md", "torus", -2, 0.25, step, light_tails},
        {{"equal-weights", "weights 1/N", monte_carlo}});
    add(catalogue,
        {"reweighting/stratified-reweighted/rate",
         "Clipped cells over g_s, one jittered sample a stratum, have an MSE of N^-2 where f(0), f(1) ≠ 0.",
         "ours, analytic/cell_weight.h", "stratified-reweighted", -2, 0.25, exponential, light_tails},
        {{"equal-weights", "weights 1/N, which fall like N^-3: reweighting costs a power here", stratified}});
    add(catalogue,
        {"reweighting/stratified/rate", "The MSE of one jittered sample a stratum with equal weights falls like N^-3.",
         "ours, docs/statistics.md", "stratified", -3, 0.25, exponential, light_tails, stratified},
        {{"reweighted", "clipped cells over g_s, which fall like N^-2", shipped("stratified-reweighted")}});
    add(catalogue,
        {"reweighting/stratified-torus/rate",
         "One jittered sample a stratum with cells on the circle: N^-2 where f(0) ≠ f(1).", "ours, docs/statistics.md",
         "stratified-torus", -2, 0.25, exponential, light_tails},
        {{"equal-weights", "weights 1/N", stratified}});
    add(catalogue,
        {"reweighting/batches/rate",
         "Batches of 16 reweighted samples: N^-1, as for any mean of independent estimates.", "[thesis, section 4.5.1]",
         "reweighted-batches-16", -1, 0.25, exponential, light_tails},
        {{"one-batch", "all samples in one batch", shipped("reweighted")}});
}

void add_fast(Catalogue& catalogue) {
    add(catalogue,
        {"reweighting/voronoi/rate", "The MSE of clipped cells falls like N^-4: bias² and variance alike.",
         "[thesis, section 4.4.1]", "voronoi", -4, 0.45, exponential, heavy_tails},
        {{"unbiased-version", "cells over g", shipped("reweighted")}});
    add(catalogue,
        {"reweighting/torus-tent/rate",
         "The MSE of cells on the circle for the folded integrand falls like N^-4, unbiased.",
         "ours, estimators/reweighting/tent.h", "torus-tent", -4, 0.45, exponential, heavy_tails},
        {{"sawtooth", "folded by 2u mod 1 in place of the tent", sawtooth(shipped("torus"))}});
    add(catalogue,
        {"reweighting/control-variate-line/rate",
         "With the line through f(0) and f(1) as control variate the reweighted estimator's MSE falls like N^-4, "
         "unbiased.",
         "ours, estimators/reweighting/control_variate_line.h", "control-variate-line", -4, 0.6, exponential,
         heavy_tails},
        {{"no-line", "the reweighted estimate of f itself", shipped("reweighted")}});
    add(catalogue,
        {"reweighting/stratified-torus-tent/rate",
         "One jittered sample a stratum, cells on the circle, folded integrand: N^-4, unbiased.",
         "ours, estimators/reweighting/tent.h", "stratified-torus-tent", -4, 0.25, exponential, light_tails},
        {{"sawtooth", "folded by 2u mod 1 in place of the tent", sawtooth(shipped("stratified-torus"))}});
    add(catalogue,
        {"reweighting/yakowitz-trapezoid/rate", "The MSE of the trapezoidal rule on random samples falls like N^-4.",
         "[Yakowitz et al. 1978]", "yakowitz-trapezoid", -4, 0.25, exponential, light_tails},
        {{"equal-weights", "weights 1/N", monte_carlo}});
    add(catalogue,
        {"reweighting/torus/rate-of-a-kink",
         "The MSE of cells on the circle falls like N^-4 for kinks of the periodic extension.",
         "ours, docs/statistics.md", "torus", -4, 0.45, periodic_kink, heavy_tails},
        {{"clipped-over-g", "cells clipped to [0,1], over g", shipped("reweighted")}});
    add(catalogue,
        {"reweighting/stratified-torus/rate-of-a-periodic-integrand",
         "One jittered sample a stratum with cells on the circle: N^-5 for a smooth periodic integrand.",
         "ours, docs/statistics.md", "stratified-torus", -5, 0.25, periodic, light_tails},
        {{"equal-weights", "weights 1/N", stratified}});
    add(catalogue,
        {"reweighting/torus/rate-of-a-periodic-integrand",
         "The MSE of cells on the circle falls like N^-5 for a smooth periodic integrand.",
         "ours, docs/statistics.md",
         "torus",
         -5,
         0.4,
         periodic,
         {{64, 128, 256, 512}, 40000},
         {},
         Sizes::full_only},
        {{"clipped-over-g", "cells clipped to [0,1], over g", shipped("reweighted")}});
    add(catalogue,
        {"reweighting/warp-torus-tent/rate",
         "Torus and tent in the primary sample of p(x) = 1/2 + x: N^-4, reached late.",
         "ours, estimators/reweighting/warp.h",
         "warp-torus-tent",
         -4,
         0.45,
         exponential,
         {{256, 512, 1024, 2048}, 40000},
         {},
         Sizes::full_only},
        {{"sawtooth", "folded by 2u mod 1 in place of the tent", sawtooth(shipped("warp-reweighted"))}});
}

}  // namespace

void add_reweighting_rates_1d(Catalogue& catalogue) {
    add_slow(catalogue);
    add_fast(catalogue);
}

}  // namespace plumb::suites
