#include <cmath>

#include "analytic/cell_weight.h"
#include "analytic/cell_weight_density.h"
#include "analytic/ordered_samples.h"
#include "estimators/batches.h"
#include "estimators/cells_1d.h"
#include "estimators/control_variate_line.h"
#include "estimators/piecewise_strata.h"
#include "estimators/reweighting_1d.h"
#include "estimators/samples_1d.h"
#include "estimators/tent.h"
#include "estimators/warp_1d.h"
#include "verification/mean.h"
#include "verification/suites/reweighting_1d.h"

// Every claim of this file integrates e^x: not linear (Voronoi's bias is 0 for lines) and not 0 at the ends.

namespace plumb {
namespace {

using Samples = std::vector<double>;
using SampleSet = Samples (*)(std::uint64_t, RandomStream&);
using Weigh = std::function<Samples(std::span<const double>)>;
using Value = std::function<double(std::uint64_t n, RandomStream&)>;

constexpr double e = 2.718281828459045235;
constexpr double integral_of_exp = e - 1;

double exponential(const Point<1>& x) {
    return std::exp(x[0]);
}

Value weighted(SampleSet draw, Weigh weigh, Function<1> f = exponential) {
    return [draw, weigh = std::move(weigh), f = std::move(f)](std::uint64_t n, RandomStream& random) {
        const Samples samples = draw(n, random), weights = weigh(samples);
        double sum = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) sum += weights[i] * f({samples[i]});
        return sum;
    };
}

// How sharply to look at which N: δ is relative to the integral.
struct At {
    std::uint64_t n;
    double delta;
};

// A quarter of the bias of the clipped cells (8.1e-3, 7.0e-3, 3.5e-3 at N = 2, 4, 8).
const std::vector<At> quarter_of_voronoi_bias{{2, 0.0021}, {4, 0.0018}, {8, 0.0009}};

Verdict means_are(const Value& value, const std::function<double(std::uint64_t)>& truth, const std::vector<At>& places,
                  const Interval& bounds, const Run& run, double epsilon = 1e-12) {
    std::vector<Verdict> parts;
    for (const auto& [n, delta] : places)
        parts.push_back(mean_is([&value, n](RandomStream& random) { return value(n, random); },
                                {.reference = truth(n),
                                 .delta = delta * integral_of_exp,
                                 .epsilon = epsilon,
                                 .bounds = bounds,
                                 .cap = std::uint64_t{1} << 23},
                                run.part(fmt::format("N={}", n), 1.0 / static_cast<double>(places.size()))));
    return all_of(std::move(parts));
}

Verdict unbiased(const Value& value, const std::vector<At>& places, const Interval& bounds, const Run& run,
                 double epsilon = 1e-12) {
    return means_are(
        value, [](std::uint64_t) { return integral_of_exp; }, places, bounds, run, epsilon);
}

// ∫_0^1 x^k e^x dx = Σ_j 1/(j! (k + j + 1)), positive terms.
double moment_of_exp(int k) {
    double sum = 0, term = 1;
    for (int j = 0; j < 25; term /= ++j) sum += term / (k + j + 1);
    return sum;
}

// ∫ g_N(x) e^x dx, from g_N by integration over the simplex.
double voronoi_mean_of_exp(std::uint64_t n) {
    const RationalPolynomial g = clipped_cell_polynomial(static_cast<int>(n));
    double sum = 0;
    for (int k = 0; k <= g.degree(); ++k) sum += g.coefficient(k).convert_to<double>() * moment_of_exp(k);
    return sum;
}

// --- the subjects -----------------------------------------------------------------------------------------------

const Value voronoi = weighted(independent_samples_1d, voronoi_weights_1d);
const Value reweighted = weighted(independent_samples_1d, reweighted_weights_1d);
const Value torus = weighted(independent_samples_1d, torus_weights_1d);
const Value stratified_voronoi = weighted(jittered_samples_1d, voronoi_weights_1d);

double folded_exponential(const Point<1>& u) {
    return exponential(tent(u));
}

const Warp1D ramp = linear_warp(0.5);  // p(x) = 1/2 + x
const Density1D ramp_density{.pdf = [](double x) { return 0.5 + x; },
                             .cdf = [](double x) { return x * (1 + x) / 2; },
                             .largest = 1.5,
                             .variation = 1,
                             .lipschitz = 1};

Samples ramp_samples(std::uint64_t n, RandomStream& random) {
    Samples samples = independent_samples_1d(n, random);
    for (double& x : samples) x = ramp.inverse_cdf(x);
    return samples;
}

PiecewiseConstant four_steps() {
    return PiecewiseConstant::equal_pieces({1, 2, 3, 4});
}

Samples step_samples(std::uint64_t n, RandomStream& random) {
    static const PiecewiseConstant density = four_steps();
    Samples samples = independent_samples_1d(n, random);
    for (double& x : samples) x = density.inverse_cdf(x);
    return samples;
}

Value control_variate(std::function<double(const Function<1>&, std::span<const double>)> estimate) {
    return [estimate = std::move(estimate)](std::uint64_t n, RandomStream& random) {
        return estimate(exponential, independent_samples_1d(n, random));
    };
}

// --- mutants ----------------------------------------------------------------------------------------------------

Samples over_g_of_fewer(std::span<const double> samples) {
    Samples weights = voronoi_weights_1d(samples);
    for (std::size_t i = 0; i < samples.size(); ++i) weights[i] /= cell_weight(samples.size() - 1, samples[i]);
    return weights;
}

Samples normalised(std::span<const double> samples) {
    Samples weights = reweighted_weights_1d(samples);
    double sum = 0;
    for (const double w : weights) sum += w;
    for (double& w : weights) w /= sum;
    return weights;
}

// The cells of the folded samples φ(u), clipped, in place of those of u on the circle.
Samples clipped_cells_of_folded(std::span<const double> samples) {
    Samples folded(samples.begin(), samples.end());
    for (double& u : folded) u = tent(u);
    return voronoi_weights_1d(folded);
}

double counts_drawn(std::uint64_t n, RandomStream& random) {
    const PiecewiseConstant pieces = PiecewiseConstant::equal_pieces(Samples(10, 1));
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
        const PiecewiseConstant pieces = PiecewiseConstant::equal_pieces(Samples(10, 1));
        return piecewise_strata_estimate(f, pieces, stratum_counts(pieces, n), random).value;
    };
}

// A fixed set, moved by one uniform shift.
Samples shifted_set(std::uint64_t, RandomStream& random) {
    const double shift = random.uniform();
    Samples samples{0, 0.1, 0.15, 0.6};
    for (double& x : samples) x = x + shift < 1 ? x + shift : x + shift - 1;
    return samples;
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
        {.delta = 0.1 * 0.0166, .cap = std::uint64_t{1} << 22}, run);
}

void add_independent(Catalogue& catalogue) {
    const Interval values{1, e};       // weights sum to 1
    const Interval doubled{0, 2 * e};  // g ≥ 1/2
    catalogue.add(
        {.id = "reweighting/voronoi/known-bias",
         .statement = "Clipped cells estimate ∫ g_N f, not ∫ f: for e^x 0.8, 0.7 and 0.35 % too little at N = 2, 4, 8.",
         .source = "thesis, eq. 4.6",
         .kind = Kind::mean,
         .check =
             [=](const Run& run) {
                 return means_are(voronoi, voronoi_mean_of_exp, quarter_of_voronoi_bias, values, run);
             },
         .mutants = {{"claimed-unbiased", "the reference is ∫ f",
                      [=](const Run& run) { return unbiased(voronoi, quarter_of_voronoi_bias, values, run); }},
                     {"torus-cells", "cells on the circle, which are unbiased", [=](const Run& run) {
                          return means_are(torus, voronoi_mean_of_exp, quarter_of_voronoi_bias, values, run);
                      }}}});
    const auto check = [=](const Value& value) {
        return [=](const Run& run) { return unbiased(value, quarter_of_voronoi_bias, doubled, run); };
    };
    catalogue.add(
        {.id = "reweighting/reweighted/unbiased",
         .statement = "Clipped cells over g_N are unbiased for i.i.d. uniform samples, at N = 2, 4, 8.",
         .source = "thesis, eq. 4.8",
         .kind = Kind::mean,
         .check = check(reweighted),
         .mutants = {
             {"consistent-weights", "the cells alone", check(voronoi)},
             {"g-of-n-minus-1", "g of N − 1 samples", check(weighted(independent_samples_1d, over_g_of_fewer))},
             {"normalised", "the weights divided by their sum", check(weighted(independent_samples_1d, normalised))}}});
    catalogue.add(
        {.id = "reweighting/torus/unbiased",
         .statement = "Cells on the circle are unbiased for i.i.d. uniform samples, at N = 2, 4, 8, without any g.",
         .source = "ours, analytic/ordered_samples.h; against thesis, appendix A.2",
         .kind = Kind::mean,
         .check = [=](const Run& run) { return unbiased(torus, quarter_of_voronoi_bias, values, run); },
         .mutants = {{"clipped-called-periodic", "cells clipped to [0,1]",
                      [=](const Run& run) { return unbiased(voronoi, quarter_of_voronoi_bias, values, run); }}}});
    const auto shift_check = [=](const Weigh& weigh) {
        return [=](const Run& run) { return unbiased(weighted(shifted_set, weigh), {{4, 0.002}}, values, run); };
    };
    catalogue.add(
        {.id = "reweighting/torus/unbiased-for-a-shifted-set",
         .statement = "Cells on the circle are unbiased for a fixed set under one uniform shift.",
         .source = "ours, methods of cells_1d.h",
         .kind = Kind::mean,
         .check = shift_check(torus_weights_1d),
         .mutants = {{"clipped-called-periodic", "cells clipped to [0,1]", shift_check(voronoi_weights_1d)}}});
    const auto tent_check = [=](const Weigh& weigh, const Function<1>& f) {
        return [=](const Run& run) {
            return unbiased(weighted(independent_samples_1d, weigh, f), quarter_of_voronoi_bias, values, run);
        };
    };
    catalogue.add(
        {.id = "reweighting/torus-tent/unbiased",
         .statement =
             "Cells on the circle with the integrand folded by φ(u) = 1 − |2u − 1| are unbiased, at N = 2, 4, 8.",
         .source = "ours, estimators/tent.h",
         .kind = Kind::mean,
         .check = tent_check(torus_weights_1d, folded_exponential),
         .mutants = {{"clipped-cells-of-the-folded", "clipped cells of the folded samples in place of the circle's",
                      tent_check(clipped_cells_of_folded, folded_exponential)},
                     {"clipped-cells", "clipped cells of the unfolded samples",
                      tent_check(voronoi_weights_1d, folded_exponential)},
                     {"tent-without-its-factor", "φ(u) = 1/2 − |u − 1/2|: [0,1/2] covered twice",
                      tent_check(torus_weights_1d, [](const Point<1>& u) { return exponential({tent(u[0]) / 2}); })}}});
}

void add_stratified(Catalogue& catalogue) {
    const std::vector<At> places{{2, 0.0021}, {4, 0.0007}, {8, 0.0007}};
    const auto check = [=](const Weigh& weigh, const Function<1>& f = exponential) {
        return [=](const Run& run) {
            return unbiased(weighted(jittered_samples_1d, weigh, f), places, {0, 2 * e}, run);
        };
    };
    catalogue.add(
        {.id = "reweighting/stratified-reweighted/unbiased",
         .statement = "Clipped cells over g_s are unbiased for one jittered sample a stratum, at N = 2, 4, 8.",
         .source = "ours, analytic/cell_weight.h",
         .kind = Kind::mean,
         .check = check(stratified_reweighted_weights_1d),
         .mutants = {{"g-of-iid-samples", "g_N of i.i.d. samples", check(reweighted_weights_1d)},
                     {"consistent-weights", "the cells alone", check(voronoi_weights_1d)}}});
    catalogue.add(
        {.id = "reweighting/stratified-torus/unbiased",
         .statement =
             "Cells on the circle are unbiased for one jittered sample a stratum, without g or shift, at N = 2, 4, 8.",
         .source = "ours, analytic/ordered_samples.h",
         .kind = Kind::mean,
         .check = check(torus_weights_1d),
         .mutants = {{"clipped-called-periodic", "cells clipped to [0,1]", check(voronoi_weights_1d)}}});
    catalogue.add({.id = "reweighting/stratified-torus-tent/unbiased",
                   .statement = "The same with the integrand folded by the tent map, at N = 2, 4, 8.",
                   .source = "ours, estimators/tent.h",
                   .kind = Kind::mean,
                   .check = check(torus_weights_1d, folded_exponential),
                   .mutants = {{"clipped-cells-of-the-folded", "clipped cells of the folded samples",
                                check(clipped_cells_of_folded, folded_exponential)},
                               {"clipped-cells", "clipped cells of the unfolded samples",
                                check(voronoi_weights_1d, folded_exponential)}}});
}

void add_control_variate(Catalogue& catalogue) {
    const auto check = [=](const Value& value) {
        // e^x minus its chord lies in [−0.212, 0]; weights sum to at most 2.
        return [=](const Run& run) {
            return unbiased(value, {{2, 0.0025}, {4, 0.0025}}, {(1 + e) / 2 - 0.424, (1 + e) / 2}, run);
        };
    };
    const auto value_of = [](const Function<1>& f, std::span<const double> samples) {
        return control_variate_estimate_1d(f, samples).value;
    };
    catalogue.add({.id = "reweighting/control-variate-line/unbiased",
                   .statement = "The reweighted estimate of f minus the line through its end values, plus the line's "
                                "integral, is unbiased.",
                   .source = "ours, estimators/control_variate_line.h",
                   .kind = Kind::mean,
                   .check = check(control_variate(value_of)),
                   .mutants = {{"integral-not-added", "∫ ℓ is not added back",
                                check(control_variate([=](const Function<1>& f, std::span<const double> samples) {
                                    return value_of(f, samples) - endpoint_line(f).integral();
                                }))},
                               {"consistent-weights", "f − ℓ weighted by the cells alone",
                                check(control_variate([](const Function<1>& f, std::span<const double> samples) {
                                    const EndpointLine line = endpoint_line(f);
                                    const Samples weights = voronoi_weights_1d(samples);
                                    double sum = line.integral();
                                    for (std::size_t i = 0; i < samples.size(); ++i)
                                        sum += weights[i] * (f({samples[i]}) - line(samples[i]));
                                    return sum;
                                }))}}});
}

void add_densities(Catalogue& catalogue) {
    const std::vector<At> places{{2, 0.002}, {4, 0.002}};
    const auto warp_check = [=](const Function<1>& f, const Weigh& weigh) {
        return [=](const Run& run) {
            return unbiased(weighted(independent_samples_1d, weigh, f), places, {0, 4.1}, run);
        };
    };
    const Function<1> off_by_its_normalisation =
        warped(exponential, {ramp.inverse_cdf, [](double x) { return (0.5 + x) / 0.995; }});
    catalogue.add(
        {.id = "reweighting/warp-reweighted/unbiased",
         .statement = "Reweighting f(T(u))/p(T(u)) in u is unbiased, for the density p(x) = 1/2 + x.",
         .source = "ours, estimators/warp_1d.h",
         .kind = Kind::mean,
         .check = warp_check(warped(exponential, ramp), reweighted_weights_1d),
         .mutants = {{"pdf-off-by-its-normalisation", "p normalised by a left Riemann sum of 100 panels, 0.995 for 1",
                      warp_check(off_by_its_normalisation, reweighted_weights_1d)},
                     {"no-pdf", "f(T(u)) without 1/p",
                      warp_check([](const Point<1>& u) { return exponential({ramp.inverse_cdf(u[0])}); },
                                 reweighted_weights_1d)}}});
    catalogue.add(
        {.id = "reweighting/warp-torus-tent/unbiased",
         .statement = "Torus and tent applied to f(T(u))/p(T(u)) are unbiased, for the density p(x) = 1/2 + x.",
         .source = "ours, estimators/warp_1d.h",
         .kind = Kind::mean,
         .check =
             warp_check([f = warped(exponential, ramp)](const Point<1>& u) { return f(tent(u)); }, torus_weights_1d),
         .mutants = {{"pdf-off-by-its-normalisation", "p normalised by a left Riemann sum of 100 panels, 0.995 for 1",
                      warp_check([f = off_by_its_normalisation](const Point<1>& u) { return f(tent(u)); },
                                 torus_weights_1d)}}});

    // ε: a relative error of g is one of the estimate, and with M = sup p = 3/2 the side of x that is at least 1/2 wide
    // gives g ≥ N/2 ∫_0^{1/2} (1 − M t)^{N−1} dt ≥ 0.31 for N ≥ 2.
    using WeightAt = std::function<double(std::uint64_t n, double x)>;
    const auto density_check = [](const WeightAt& g, bool with_pdf) {
        return [=](const Run& run) {
            std::vector<Verdict> parts;
            for (const At& place : {At{2, 0.0035}, At{4, 0.0022}}) {
                const std::uint64_t n = place.n;
                const CellWeightTable table(n, ramp_density, 1e-4);
                const auto at = [&](double x) { return g ? g(n, x) : table(x); };
                const auto pdf = [&](double x) { return with_pdf ? ramp_density.pdf(x) : 1.0; };
                const Weigh weigh = [&](std::span<const double> samples) {
                    return density_reweighted_weights_1d(samples, at, pdf);
                };
                parts.push_back(unbiased(weighted(ramp_samples, weigh), {place}, {0, 6.1},
                                         run.part(fmt::format("{}", n), 0.5),
                                         table.error_bound() / 0.3 * integral_of_exp));
            }
            return all_of(std::move(parts));
        };
    };
    catalogue.add(
        {.id = "reweighting/g-density/unbiased",
         .statement =
             "Clipped cells over g p, g tabulated for the density p(x) = 1/2 + x, are unbiased, at N = 2 and 4.",
         .source = "ours, analytic/cell_weight_density.h",
         .kind = Kind::mean,
         .check = density_check({}, true),
         .mutants = {
             {"g-of-uniform-samples", "g_N(x) of uniform samples", density_check(cell_weight, true)},
             {"uniform-g-warped", "g_N(F(x)): the law of cells in u, not in x",
              density_check([](std::uint64_t n, double x) { return cell_weight(n, ramp_density.cdf(x)); }, true)},
             {"no-pdf", "|V|/g without 1/p", density_check({}, false)}}});

    const auto step_check = [=](const Weigh& weigh) {
        return [=](const Run& run) {
            return unbiased(weighted(step_samples, weigh), {{2, 0.0045}, {4, 0.004}}, {0, 10.3}, run);
        };
    };
    catalogue.add(
        {.id = "reweighting/density-reweighted/unbiased",
         .statement =
             "Clipped cells over g p, g in closed form for a density of four steps, are unbiased, at N = 2 and 4.",
         .source = "ours, analytic/cell_weight_density.h",
         .kind = Kind::mean,
         .check = step_check([density = four_steps()](std::span<const double> samples) {
             return density_reweighted_weights_1d(samples, density);
         }),
         .mutants = {{"uniform-g-warped", "g_N(F(x)): the law of cells in u, not in x",
                      step_check([density = four_steps()](std::span<const double> samples) {
                          return density_reweighted_weights_1d(
                              samples, [&](double x) { return cell_weight(samples.size(), density.cdf(x)); },
                              [&](double x) { return density.pdf(x); });
                      })},
                     {"g-of-n-minus-1", "g of N − 1 samples",
                      step_check([density = four_steps()](std::span<const double> samples) {
                          return density_reweighted_weights_1d(
                              samples, [&](double x) { return piecewise_cell_weight(samples.size() - 1, x, density); },
                              [&](double x) { return density.pdf(x); });
                      })}}});
}

void add_strata_and_batches(Catalogue& catalogue) {
    const auto check = [=](const Value& value) {
        return [=](const Run& run) { return unbiased(value, {{16, 0.005}}, {0, 2 * e}, run); };
    };
    catalogue.add(
        {.id = "reweighting/piecewise-strata/unbiased",
         .statement = "Pieces of a piecewise-constant density, each reweighted by itself with a fixed count ≥ 1, are "
                      "unbiased: 10 pieces, N = 16.",
         .source = "thesis, section 4.4.4",
         .kind = Kind::mean,
         .check = check(ten_strata(exponential)),
         .mutants = {{"counts-drawn", "counts of i.i.d. samples: empty strata are lost, −18.5 %", check(counts_drawn)},
                     {"last-piece-cut", "the last piece ends at 0.99",
                      check(ten_strata([](const Point<1>& x) { return x[0] < 0.99 ? std::exp(x[0]) : 0; }))}}});
    const auto batch_check = [=](const Value& value) {
        return [=](const Run& run) { return unbiased(value, {{16, 0.0018}}, {0, 2 * e}, run); };
    };
    catalogue.add(
        {.id = "reweighting/batches/unbiased",
         .statement = "The mean of four reweighted batches of four samples is unbiased.",
         .source = "thesis, section 4.5.1",
         .kind = Kind::mean,
         .check = batch_check([](std::uint64_t n, RandomStream& random) { return four_batches(n, random).value; }),
         .mutants = {{"consistent-weights", "batches weighted by the cells alone: averaging keeps their bias",
                      batch_check([](std::uint64_t n, RandomStream& random) {
                          return mean_of_batches([](std::uint64_t size,
                                                    RandomStream& r) { return Estimate{.value = voronoi(size, r)}; },
                                                 n, 4, random)
                              .value;
                      })}}});
    catalogue.add(
        {.id = "reweighting/batches/error-bar",
         .statement = "The squared standard error of four batches is in the mean the squared error of their mean.",
         .source = "ours, estimators/batches.h",
         .kind = Kind::mean,
         .check = [](const Run& run) { return error_bar_is_true(1, run); },
         .mutants = {{"divided-by-n", "variance over n in place of n − 1: a quarter too small",
                      [](const Run& run) { return error_bar_is_true(std::sqrt(0.75), run); }}}});
}

}  // namespace

void add_reweighting_1d_mean_claims(Catalogue& catalogue) {
    add_independent(catalogue);
    add_stratified(catalogue);
    add_control_variate(catalogue);
    add_densities(catalogue);
    add_strata_and_batches(catalogue);
}

}  // namespace plumb
