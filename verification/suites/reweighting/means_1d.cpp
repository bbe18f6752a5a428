#include <cmath>

#include "analytic/cell_weight.h"
#include "analytic/ordered_samples.h"
#include "estimators/reweighting/cells_1d.h"
#include "estimators/reweighting/control_variate_line.h"
#include "estimators/reweighting/reweighting_1d.h"
#include "estimators/reweighting/samples_1d.h"
#include "estimators/reweighting/tent.h"
#include "verification/claim.h"
#include "verification/suites/reweighting/exponential_1d.h"

namespace plumb::suites {
namespace {

using namespace reweighting_1d;

// A quarter of the bias of the clipped cells (8.1e-3, 7.0e-3, 3.5e-3 at N = 2, 4, 8).
const std::vector<At> quarter_of_voronoi_bias{{2, 0.0021}, {4, 0.0018}, {8, 0.0009}};

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

const Value voronoi = weighted(independent_samples_1d, voronoi_weights_1d);
const Value reweighted = weighted(independent_samples_1d, reweighted_weights_1d);
const Value torus = weighted(independent_samples_1d, torus_weights_1d);

double folded_exponential(const Point<1>& u) {
    return exponential(tent(u));
}

Value control_variate(std::function<double(const Function<1>&, std::span<const double>)> estimate) {
    return [estimate = std::move(estimate)](std::uint64_t n, RandomStream& random) {
        return estimate(exponential, independent_samples_1d(n, random));
    };
}

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

// A fixed set, moved by one uniform shift.
Samples shifted_set(std::uint64_t, RandomStream& random) {
    const double shift = random.uniform();
    Samples samples{0, 0.1, 0.15, 0.6};
    for (double& x : samples) x = x + shift < 1 ? x + shift : x + shift - 1;
    return samples;
}

// An estimate, and its mean as it is claimed.
struct Biased {
    Value value;
    std::function<double(std::uint64_t n)> mean;
};

const Interval values{1, e};       // weights sum to 1
const Interval doubled{0, 2 * e};  // g ≥ 1/2

Verdict weights_are_unbiased(const Value& value, const Run& run) {
    return unbiased(value, quarter_of_voronoi_bias, values, run);
}

void add_independent(Catalogue& catalogue) {
    catalogue.add(
        {.id = "reweighting/voronoi/known-bias",
         .statement = "Clipped cells estimate ∫ g_N f, not ∫ f: for e^x 0.8, 0.7 and 0.35 % too little at N = 2, 4, 8.",
         .source = "[thesis, eq. 4.6]",
         .kind = Kind::mean,
         .trial = {
             [=](const Biased& claimed, const Run& run) {
                 return means_are(claimed.value, claimed.mean, quarter_of_voronoi_bias, values, run);
             },
             {voronoi, voronoi_mean_of_exp},
             {{"claimed-unbiased", "the reference is ∫ f", {voronoi, [](std::uint64_t) { return integral_of_exp; }}},
              {"torus-cells", "cells on the circle, which are unbiased", {torus, voronoi_mean_of_exp}}}}});
    const auto check = [=](const Value& value, const Run& run) {
        return unbiased(value, quarter_of_voronoi_bias, doubled, run);
    };
    catalogue.add(
        {.id = "reweighting/reweighted/unbiased",
         .statement = "Clipped cells over g_N are unbiased for i.i.d. uniform samples, at N = 2, 4, 8.",
         .source = "[thesis, eq. 4.8]",
         .kind = Kind::mean,
         .trial = {
             check,
             reweighted,
             {{"consistent-weights", "the cells alone", voronoi},
              {"g-of-n-minus-1", "g of N − 1 samples", weighted(independent_samples_1d, over_g_of_fewer)},
              {"normalised", "the weights divided by their sum", weighted(independent_samples_1d, normalised)}}}});
}

void add_torus(Catalogue& catalogue) {
    catalogue.add(
        {.id = "reweighting/torus/unbiased",
         .statement = "Cells on the circle are unbiased for i.i.d. uniform samples, at N = 2, 4, 8, without any g.",
         .source = "ours, analytic/ordered_samples.h; against [thesis, appendix A.2]",
         .kind = Kind::mean,
         .trial = {weights_are_unbiased, torus, {{"clipped-called-periodic", "cells clipped to [0,1]", voronoi}}}});
    const auto shift_check = [=](const Weigh& weigh, const Run& run) {
        return unbiased(weighted(shifted_set, weigh), {{4, 0.002}}, values, run);
    };
    catalogue.add({.id = "reweighting/torus/unbiased-for-a-shifted-set",
                   .statement = "Cells on the circle are unbiased for a fixed set under one uniform shift.",
                   .source = "ours, estimators/reweighting/cells_1d.h",
                   .kind = Kind::mean,
                   .trial = {shift_check,
                             torus_weights_1d,
                             {{"clipped-called-periodic", "cells clipped to [0,1]", voronoi_weights_1d}}}});
    const auto folded = [](const Weigh& weigh) { return weighted(independent_samples_1d, weigh, folded_exponential); };
    const Function<1> half_folded = [](const Point<1>& u) { return exponential({tent(u[0]) / 2}); };
    catalogue.add(
        {.id = "reweighting/torus-tent/unbiased",
         .statement =
             "Cells on the circle with the integrand folded by φ(u) = 1 − |2u − 1| are unbiased, at N = 2, 4, 8.",
         .source = "ours, estimators/reweighting/tent.h",
         .kind = Kind::mean,
         .trial = {weights_are_unbiased,
                   folded(torus_weights_1d),
                   {{"clipped-cells-of-the-folded", "clipped cells of the folded samples in place of the circle's",
                     folded(clipped_cells_of_folded)},
                    {"clipped-cells", "clipped cells of the unfolded samples", folded(voronoi_weights_1d)},
                    {"tent-without-its-factor", "φ(u) = 1/2 − |u − 1/2|: [0,1/2] covered twice",
                     weighted(independent_samples_1d, torus_weights_1d, half_folded)}}}});
}

void add_stratified(Catalogue& catalogue) {
    const std::vector<At> places{{2, 0.0021}, {4, 0.0007}, {8, 0.0007}};
    const auto check = [=](const Weigh& weigh, const Run& run) {
        return unbiased(weighted(jittered_samples_1d, weigh), places, {0, 2 * e}, run);
    };
    const auto folded_check = [=](const Weigh& weigh, const Run& run) {
        return unbiased(weighted(jittered_samples_1d, weigh, folded_exponential), places, {0, 2 * e}, run);
    };
    catalogue.add(
        {.id = "reweighting/stratified-reweighted/unbiased",
         .statement = "Clipped cells over g_s are unbiased for one jittered sample a stratum, at N = 2, 4, 8.",
         .source = "ours, analytic/cell_weight.h",
         .kind = Kind::mean,
         .trial = {check,
                   stratified_reweighted_weights_1d,
                   {{"g-of-iid-samples", "g_N of i.i.d. samples", reweighted_weights_1d},
                    {"consistent-weights", "the cells alone", voronoi_weights_1d}}}});
    catalogue.add(
        {.id = "reweighting/stratified-torus/unbiased",
         .statement =
             "Cells on the circle are unbiased for one jittered sample a stratum, without g or shift, at N = 2, 4, 8.",
         .source = "ours, analytic/ordered_samples.h",
         .kind = Kind::mean,
         .trial = {
             check, torus_weights_1d, {{"clipped-called-periodic", "cells clipped to [0,1]", voronoi_weights_1d}}}});
    catalogue.add(
        {.id = "reweighting/stratified-torus-tent/unbiased",
         .statement = "The same with the integrand folded by the tent map, at N = 2, 4, 8.",
         .source = "ours, estimators/reweighting/tent.h",
         .kind = Kind::mean,
         .trial = {folded_check,
                   torus_weights_1d,
                   {{"clipped-cells-of-the-folded", "clipped cells of the folded samples", clipped_cells_of_folded},
                    {"clipped-cells", "clipped cells of the unfolded samples", voronoi_weights_1d}}}});
}

void add_control_variate(Catalogue& catalogue) {
    const auto check = [](const Value& value, const Run& run) {
        // e^x minus its chord lies in [−0.212, 0]; weights sum to at most 2.
        return unbiased(value, {{2, 0.0025}, {4, 0.0025}}, {(1 + e) / 2 - 0.424, (1 + e) / 2}, run);
    };
    const auto value_of = [](const Function<1>& f, std::span<const double> samples) {
        return control_variate_estimate_1d(f, samples).value;
    };
    catalogue.add({.id = "reweighting/control-variate-line/unbiased",
                   .statement = "The reweighted estimate of f minus the line through its end values, plus the line's "
                                "integral, is unbiased.",
                   .source = "ours, estimators/reweighting/control_variate_line.h",
                   .kind = Kind::mean,
                   .trial = {check,
                             control_variate(value_of),
                             {{"integral-not-added", "∫ ℓ is not added back",
                               control_variate([=](const Function<1>& f, std::span<const double> samples) {
                                   return value_of(f, samples) - endpoint_line(f).integral();
                               })},
                              {"consistent-weights", "f − ℓ weighted by the cells alone",
                               control_variate([](const Function<1>& f, std::span<const double> samples) {
                                   const EndpointLine line = endpoint_line(f);
                                   const Samples weights = voronoi_weights_1d(samples);
                                   double sum = line.integral();
                                   for (std::size_t i = 0; i < samples.size(); ++i)
                                       sum += weights[i] * (f({samples[i]}) - line(samples[i]));
                                   return sum;
                               })}}}});
}

}  // namespace

void add_reweighting_means_1d(Catalogue& catalogue) {
    add_independent(catalogue);
    add_torus(catalogue);
    add_stratified(catalogue);
    add_control_variate(catalogue);
}

}  // namespace plumb::suites
