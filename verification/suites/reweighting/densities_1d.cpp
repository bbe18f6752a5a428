#include <cmath>

#include "analytic/cell_weight.h"
#include "analytic/cell_weight_density.h"
#include "estimators/densities/density.h"
#include "estimators/replicates/batches.h"
#include "estimators/reweighting/cells_1d.h"
#include "estimators/reweighting/piecewise_strata.h"
#include "estimators/reweighting/reweighting_1d.h"
#include "estimators/reweighting/samples_1d.h"
#include "estimators/reweighting/tent.h"
#include "estimators/reweighting/warp.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"
#include "verification/suites/reweighting/exponential_1d.h"

namespace plumb::suites {
namespace {

using namespace reweighting_1d;

const Value voronoi = weighted(independent_samples_1d, voronoi_weights_1d);
const Value reweighted = weighted(independent_samples_1d, reweighted_weights_1d);

const LinearDensity ramp(0.5, 1.5);  // p(x) = 1/2 + x
const Density1D ramp_density{.pdf = [](double x) { return 0.5 + x; },
                             .cdf = [](double x) { return x * (1 + x) / 2; },
                             .largest = 1.5,
                             .variation = 1,
                             .lipschitz = 1};

// p divided by its left Riemann sum of 100 panels, which is 0.995.
struct RampOffByItsNormalisation {
    static double sample(double u) { return ramp.sample(u); }
    static double pdf(double x) { return ramp.pdf(x) / 0.995; }
};

Samples ramp_samples(std::uint64_t n, RandomStream& random) {
    Samples samples = independent_samples_1d(n, random);
    for (double& x : samples) x = ramp.sample(x);
    return samples;
}

StepDensity four_steps() {
    return StepDensity::equal_pieces({1, 2, 3, 4});
}

Samples step_samples(std::uint64_t n, RandomStream& random) {
    static const StepDensity density = four_steps();
    Samples samples = independent_samples_1d(n, random);
    for (double& x : samples) x = density.sample(x);
    return samples;
}

double counts_drawn(std::uint64_t n, RandomStream& random) {
    std::vector<Samples> strata(10);
    for (std::uint64_t i = 0; i < n; ++i) strata[random.below(10)].push_back(random.uniform());
    double sum = 0;
    for (std::size_t k = 0; k < strata.size(); ++k) {
        if (strata[k].empty()) continue;
        const Samples weights = reweighted_weights_1d(strata[k]);
        for (std::size_t i = 0; i < weights.size(); ++i)
            sum += 0.1 * weights[i] * std::exp(0.1 * (static_cast<double>(k) + strata[k][i]));
    }
    return sum;
}

Value ten_strata(Function<1> f) {
    return [f = std::move(f)](std::uint64_t n, RandomStream& random) {
        const StepDensity pieces = StepDensity::equal_pieces(Samples(10, 1));
        return piecewise_strata_estimate(f, pieces, stratum_counts(pieces, n), random).value;
    };
}

Estimate four_batches(std::uint64_t n, RandomStream& random) {
    return mean_of_batches([](std::uint64_t size, RandomStream& r) { return Estimate{.value = reweighted(size, r)}; },
                           n, 4, random);
}

// Squared error minus squared error bar of four batches of four samples: 0 in the mean.
Verdict error_bar_is_true(double scale, const Run& run) {
    return mean_is(
        [scale](RandomStream& random) {
            const Estimate mean = four_batches(16, random);
            const double error = mean.value - integral_of_exp, bar = scale * mean.standard_error;
            return error * error - bar * bar;
        },
        {.delta = 0.1 * 0.0166,
         .why_fewer = "weights of at most 1 on e^x: squares below 3",
         .cap = std::uint64_t{1} << 22},
        run);
}

void add_warps(Catalogue& catalogue) {
    const std::vector<At> places{{2, 0.002}, {4, 0.002}};
    const auto warp_check = [=](const Function<1>& f, const Weigh& weigh, const Run& run) {
        return unbiased(weighted(independent_samples_1d, weigh, f), places, {0, 4.1}, run);
    };
    const Function<1> off_by_its_normalisation = warped(exponential, RampOffByItsNormalisation{});
    catalogue.add(
        {.id = "reweighting/warp-reweighted/unbiased",
         .statement = "Reweighting f(T(u))/p(T(u)) in u is unbiased, for the density p(x) = 1/2 + x.",
         .source = "ours, estimators/reweighting/warp.h",
         .kind = Kind::mean,
         .trial = {
             [=](const Function<1>& f, const Run& run) { return warp_check(f, reweighted_weights_1d, run); },
             warped(exponential, ramp),
             {{"pdf-off-by-its-normalisation", "p normalised by a left Riemann sum of 100 panels, 0.995 for 1",
               off_by_its_normalisation},
              {"no-pdf", "f(T(u)) without 1/p", [](const Point<1>& u) { return exponential({ramp.sample(u[0])}); }}}}});
    catalogue.add(
        {.id = "reweighting/warp-torus-tent/unbiased",
         .statement = "Torus and tent applied to f(T(u))/p(T(u)) are unbiased, for the density p(x) = 1/2 + x.",
         .source = "ours, estimators/reweighting/warp.h",
         .kind = Kind::mean,
         .trial = {[=](const Function<1>& f, const Run& run) { return warp_check(f, torus_weights_1d, run); },
                   [f = warped(exponential, ramp)](const Point<1>& u) { return f(tent(u)); },
                   {{"pdf-off-by-its-normalisation", "p normalised by a left Riemann sum of 100 panels, 0.995 for 1",
                     [f = off_by_its_normalisation](const Point<1>& u) { return f(tent(u)); }}}}});
}

// What cells are divided by: g p.
struct Division {
    std::function<double(std::uint64_t n, double x)> g;  ///< empty: tabulated
    std::function<double(double)> pdf;
};

// ε: a relative error of g is one of the estimate, and with M = sup p = 3/2 the side of x that is at least 1/2 wide
// gives g ≥ N/2 ∫_0^{1/2} (1 − M t)^{N−1} dt ≥ 0.31 for N ≥ 2.
Verdict division_is_unbiased(const Division& by, const Run& run) {
    std::vector<Verdict> parts;
    for (const At& place : {At{2, 0.0035}, At{4, 0.0022}}) {
        const std::uint64_t n = place.n;
        const CellWeightTable table(n, ramp_density, 1e-4);
        const auto at = [&](double x) { return by.g ? by.g(n, x) : table(x); };
        const Weigh weigh = [&](std::span<const double> samples) {
            return density_reweighted_weights_1d(samples, at, by.pdf);
        };
        parts.push_back(unbiased(weighted(ramp_samples, weigh), {place}, {0, 6.1}, run.part(fmt::format("{}", n), 0.5),
                                 table.error_bound() / 0.3 * integral_of_exp));
    }
    return all_of(std::move(parts));
}

void add_densities(Catalogue& catalogue) {
    const auto ramp_pdf = [](double x) { return ramp_density.pdf(x); };
    catalogue.add(
        {.id = "reweighting/g-density/unbiased",
         .statement =
             "Clipped cells over g p, g tabulated for the density p(x) = 1/2 + x, are unbiased, at N = 2 and 4.",
         .source = "ours, analytic/cell_weight_density.h",
         .kind = Kind::mean,
         .trial = {division_is_unbiased,
                   {{}, ramp_pdf},
                   {{"g-of-uniform-samples", "g_N(x) of uniform samples", {cell_weight, ramp_pdf}},
                    {"uniform-g-warped",
                     "g_N(F(x)): the law of cells in u, not in x",
                     {[](std::uint64_t n, double x) { return cell_weight(n, ramp_density.cdf(x)); }, ramp_pdf}},
                    {"no-pdf", "|V|/g without 1/p", {{}, [](double) { return 1.0; }}}}}});

    const auto step_check = [=](const Weigh& weigh, const Run& run) {
        return unbiased(weighted(step_samples, weigh), {{2, 0.0045}, {4, 0.004}}, {0, 10.3}, run);
    };
    catalogue.add(
        {.id = "reweighting/density-reweighted/unbiased",
         .statement =
             "Clipped cells over g p, g in closed form for a density of four steps, are unbiased, at N = 2 and 4.",
         .source = "ours, analytic/cell_weight_density.h",
         .kind = Kind::mean,
         .trial = {step_check,
                   [density = four_steps()](std::span<const double> samples) {
                       return density_reweighted_weights_1d(samples, density);
                   },
                   {{"uniform-g-warped", "g_N(F(x)): the law of cells in u, not in x",
                     [density = four_steps()](std::span<const double> samples) {
                         return density_reweighted_weights_1d(
                             samples, [&](double x) { return cell_weight(samples.size(), density.invert(x)); },
                             [&](double x) { return density.pdf(x); });
                     }},
                    {"g-of-n-minus-1", "g of N − 1 samples", [density = four_steps()](std::span<const double> samples) {
                         return density_reweighted_weights_1d(
                             samples, [&](double x) { return piecewise_cell_weight(samples.size() - 1, x, density); },
                             [&](double x) { return density.pdf(x); });
                     }}}}});
}

void add_strata_and_batches(Catalogue& catalogue) {
    const auto check = [=](const Value& value, const Run& run) {
        return unbiased(value, {{16, 0.005}}, {0, 2 * e}, run);
    };
    catalogue.add(
        {.id = "reweighting/piecewise-strata/unbiased",
         .statement = "Pieces of a piecewise-constant density, each reweighted by itself with a fixed count ≥ 1, are "
                      "unbiased: 10 pieces, N = 16.",
         .source = "[thesis, section 4.4.4]",
         .kind = Kind::mean,
         .trial = {check,
                   ten_strata(exponential),
                   {{"counts-drawn", "counts of i.i.d. samples: empty strata are lost, −18.5 %", counts_drawn},
                    {"last-piece-cut", "the last piece ends at 0.99",
                     ten_strata([](const Point<1>& x) { return x[0] < 0.99 ? std::exp(x[0]) : 0; })}}}});
    const auto batch_check = [=](const Value& value, const Run& run) {
        return unbiased(value, {{16, 0.0018}}, {0, 2 * e}, run);
    };
    catalogue.add({.id = "reweighting/batches/unbiased",
                   .statement = "The mean of four reweighted batches of four samples is unbiased.",
                   .source = "[thesis, section 4.5.1]",
                   .kind = Kind::mean,
                   .trial = {batch_check,
                             [](std::uint64_t n, RandomStream& random) { return four_batches(n, random).value; },
                             {{"consistent-weights", "batches weighted by the cells alone: averaging keeps their bias",
                               [](std::uint64_t n, RandomStream& random) {
                                   return mean_of_batches(
                                              [](std::uint64_t size, RandomStream& r) {
                                                  return Estimate{.value = voronoi(size, r)};
                                              },
                                              n, 4, random)
                                       .value;
                               }}}}});
    catalogue.add(
        {.id = "reweighting/batches/error-bar",
         .statement = "The squared standard error of four batches is in the mean the squared error of their mean.",
         .source = "ours, estimators/replicates/batches.h",
         .kind = Kind::mean,
         .trial = {error_bar_is_true,
                   1,
                   {{"divided-by-n", "variance over n in place of n − 1: a quarter too small", std::sqrt(0.75)}}}});
}

}  // namespace

void add_reweighting_densities_1d(Catalogue& catalogue) {
    add_warps(catalogue);
    add_densities(catalogue);
    add_strata_and_batches(catalogue);
}

}  // namespace plumb::suites
