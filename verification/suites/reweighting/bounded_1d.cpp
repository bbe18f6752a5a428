#include <cmath>

#include "analytic/cell_weight.h"
#include "analytic/cell_weight_density.h"
#include "analytic/cell_weight_exact.h"
#include "analytic/ordered_samples.h"
#include "estimators/reweighting/cells_1d.h"
#include "estimators/reweighting/reweighting_1d.h"
#include "estimators/reweighting/samples_1d.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {
namespace {

using Samples = std::vector<double>;
using Weigh = std::function<Samples(std::span<const double>)>;
using CellWeight = std::function<double(std::uint64_t n, double x)>;

struct NamedSet {
    std::string name;
    Samples samples;
};

Samples near_zero_point_three(std::uint64_t n, double width, RandomStream& random) {
    Samples samples = independent_samples_1d(n, random);
    for (double& x : samples) x = 0.3 + width * x;
    return samples;
}

std::vector<NamedSet> hard_sets(const Run& run) {
    RandomStream random = run.random(0);
    constexpr double tiny = 0x1p-1074, last = 1 - 0x1p-53;
    return {
        {"one sample", {0.3}},
        {"one sample at 0", {0}},
        {"one sample at 1", {1}},
        {"two samples", {0.9, 0.2}},
        {"both ends", {0, 1}},
        {"both ends and the smallest double", {0, tiny, 1}},
        {"extreme doubles", {tiny, 2 * tiny, 0x1p-1022, 1 - 0x1p-52, last}},
        {"all coincident", Samples(17, 0.3)},
        {"all at 1", Samples(5, 1)},
        {"coincident groups, unsorted", {0.5, 0, 0.25, 0.5, 1, 0, 0.25, 0.5}},
        {"10^4 samples within 1e-12", near_zero_point_three(10'000, 1e-12, random)},
        {"1000 jittered samples", jittered_samples_1d(1000, random)},
    };
}

double off_one(const Samples& weights) {
    long double sum = 0;
    for (const double weight : weights) sum += weight;
    return static_cast<double>(std::abs(sum - 1));
}

Verdict sum_to_one(const Weigh& weigh, const Run& run) {
    const auto many = run.pick<std::uint64_t>(100'000, 10'000'000);
    std::vector<BoundedCase> cases;
    for (const auto& [name, samples] : hard_sets(run))
        cases.push_back({name, off_one(weigh(samples)), static_cast<double>(samples.size())});
    RandomStream random = run.random(1);
    cases.push_back({fmt::format("{} independent samples", many), off_one(weigh(independent_samples_1d(many, random))),
                     static_cast<double>(many)});
    return within_bound(cases, 1e-12, "absolute");
}

// Each of several coincident samples gets their whole cell.
Samples torus_weights_unshared(std::span<const double> samples) {
    Samples weights = torus_weights_1d(samples), sorted(samples.begin(), samples.end());
    std::ranges::sort(sorted);
    for (std::size_t i = 0; i < samples.size(); ++i)
        weights[i] *= static_cast<double>(std::ranges::equal_range(sorted, samples[i]).size());
    return weights;
}

// A cell as the intersection of half-lines, one for each other sample (and each of its periodic copies): O(N²) and
// without sorting. Samples at one place share; on the circle 1 is 0.
Samples cells_by_half_lines(Samples samples, bool periodic) {
    if (periodic) std::ranges::replace(samples, 1.0, 0.0);
    Samples lengths;
    for (const double x : samples) {
        double low = periodic ? x - 0.5 : 0, high = periodic ? x + 0.5 : 1;
        int sharing = 0;
        for (const double y : samples)
            for (const double copy : {y - 1, y, y + 1}) {
                if (copy != y && !periodic) continue;
                if (copy == x) ++sharing;
                if (copy < x) low = std::max(low, (copy + x) / 2);
                if (copy > x) high = std::min(high, (copy + x) / 2);
            }
        lengths.push_back((high - low) / sharing);
    }
    return lengths;
}

Verdict agrees_with_half_lines(const Weigh& weigh, bool periodic, const Run& run) {
    std::vector<BoundedCase> cases;
    for (const auto& [name, samples] : hard_sets(run)) {
        if (samples.size() > 1000) continue;
        const Samples found = weigh(samples), truth = cells_by_half_lines(samples, periodic);
        double worst = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) worst = std::max(worst, std::abs(found[i] - truth[i]));
        cases.push_back({name, worst, static_cast<double>(samples.size())});
    }
    return within_bound(cases, 0x1p-50, "absolute");
}

// The places where 1 − x rounds, where the end terms change sign (1/(N+1)) and peak (2/N), and the ends of the doubles.
std::vector<double> hard_places(double n) {
    std::vector<double> places{0x1p-1074, 0x1p-1022, 0x1p-54, 0x1p-53,     0x1p-30,     0.1,
                               1.0 / 3,   0.5,       0.7,     1 - 0x1p-30, 1 - 0x1p-52, 1 - 0x1p-53};
    for (const double scaled : {0.01, 0.5, 1.0, 2.0, 3.7, 10.0, 30.0, 59.9, 60.1}) {
        const double x = scaled / (n + 1);
        if (x < 0.5) places.insert(places.end(), {x, std::nextafter(x, 0), std::nextafter(x, 1), 1 - x});
    }
    return places;
}

Verdict within_8_ulp(const CellWeight& g) {
    std::vector<BoundedCase> cases;
    for (const std::uint64_t n :
         {1ull, 2ull, 3ull, 4ull, 7ull, 16ull, 1000ull, 65536ull, 1'000'003ull, 1'000'000'000ull})
        for (const double x : hard_places(static_cast<double>(n)))
            cases.push_back({fmt::format("N = {}, x = {:.17g}", n, x), cell_weight_ulps(g(n, x), n, x), x});
    return stable(cases, 8, "g_N(x)", "x");
}

double by_pow(std::uint64_t count, double x) {
    const double n = static_cast<double>(count);
    return ((n - n * x - x) * std::pow(x, n - 1) + (n * x + x - 1) * std::pow(1 - x, n - 1) + 2) / 2;
}

// The stratum of x by exact comparison, its polynomial by integration, evaluated in rationals.
Verdict stratified_within_2_ulp(const CellWeight& g) {
    std::vector<BoundedCase> cases;
    for (const int n : {2, 3, 7, 49, 1000, 1'000'000'000})
        for (const double x : hard_places(n)) {
            const Rational exact(x), scaled = exact * n;
            const int k = static_cast<int>(numerator(scaled) / denominator(scaled));
            const double truth = stratified_cell_polynomial(n, k)(exact).convert_to<double>();
            cases.push_back(
                {fmt::format("N = {}, x = {:.17g}", n, x), ulp_error(g(static_cast<std::uint64_t>(n), x), truth), x});
        }
    return stable(cases, 2, "g_s(x)", "x");
}

Density1D uniform_density() {
    return {.pdf = [](double) { return 1.0; }, .cdf = [](double x) { return x; }, .largest = 1};
}

using Quadrature = std::function<BoundedValue(std::uint64_t n, double x, const Density1D& density, int panels)>;

// Errors in units of the derived bound (rounding added), for the uniform density and for one of three steps.
Verdict quadrature_within_its_bound(const Quadrature& quadrature) {
    const StepDensity steps({0, 0.2, 0.7, 1}, {0.5, 0.2, 0.3});
    const Density1D step_density{.pdf = [&](double x) { return steps.pdf(x); },
                                 .cdf = [&](double x) { return steps.invert(x); },
                                 .largest = 2.5,
                                 .variation = 2.1 + 0.6};
    std::vector<BoundedCase> cases;
    for (const std::uint64_t n : {1ull, 2ull, 5ull, 16ull, 64ull})
        for (int i = 0; i <= 10; ++i) {
            const double x = i / 10.0;
            const auto add = [&](const char* name, const BoundedValue& found, double truth) {
                cases.push_back({fmt::format("{}, N = {}, x = {:.3g}", name, n, x),
                                 std::abs(found.value - truth) / (found.error + 1e-12), x});
            };
            add("uniform", quadrature(n, x, uniform_density(), 1000), cell_weight(n, x));
            add("three steps", quadrature(n, x, step_density, 1000), piecewise_cell_weight(n, x, steps));
        }
    return within_bound(cases, 1, "derived bounds");
}

Verdict integrates_lines(const Weigh& node_weights, const Run& run) {
    std::vector<BoundedCase> cases;
    for (auto& [name, samples] : hard_sets(run)) {
        const Samples weights = node_weights(samples);
        samples.insert(samples.end(), {0, 1});
        long double sum = 0;
        for (std::size_t i = 0; i < weights.size(); ++i)
            sum += static_cast<long double>(weights[i]) * (3 - 2 * samples[i]);
        cases.push_back({name, static_cast<double>(std::abs(sum - 2)), static_cast<double>(samples.size())});
    }
    return within_bound(cases, 1e-12, "absolute");
}

void add_cells(Catalogue& catalogue) {
    catalogue.add(
        {.id = "reweighting/voronoi-1d/sum",
         .statement =
             "Clipped cells of any samples sum to 1 within 1e-12: coincident, clustered, on the boundary, many.",
         .source = "[thesis, eq. 4.4]",
         .kind = Kind::bounded,
         .trial = {sum_to_one,
                   voronoi_weights_1d,
                   {{"over-g", "the cells over their expected length, which sum to 1 in the mean only",
                     reweighted_weights_1d}}}});
    catalogue.add({.id = "reweighting/torus-1d/sum",
                   .statement = "Cells on the circle sum to 1 within 1e-12, for the same hard sets.",
                   .source = "ours, estimators/reweighting/cells_1d.h",
                   .kind = Kind::bounded,
                   .trial = {sum_to_one,
                             torus_weights_1d,
                             {{"coincident-each-get-all", "coincident samples each get the whole cell",
                               torus_weights_unshared}}}});
    catalogue.add(
        {.id = "reweighting/voronoi-1d/cells",
         .statement = "Clipped cells are those of a sort-free construction from half-lines.",
         .source = "[thesis, section 4.4.1]",
         .kind = Kind::bounded,
         .trial = {[](const Weigh& weigh, const Run& run) { return agrees_with_half_lines(weigh, false, run); },
                   voronoi_weights_1d,
                   {{"wrapped", "cells on the circle", torus_weights_1d}}}});
    catalogue.add(
        {.id = "reweighting/torus-1d/cells",
         .statement = "Cells on the circle are those of a sort-free construction from half-lines of periodic copies.",
         .source = "ours, estimators/reweighting/cells_1d.h",
         .kind = Kind::bounded,
         .trial = {[](const Weigh& weigh, const Run& run) { return agrees_with_half_lines(weigh, true, run); },
                   torus_weights_1d,
                   {{"clipped-called-periodic", "cells clipped to [0,1]", voronoi_weights_1d}}}});
}

void add_formulas(Catalogue& catalogue) {
    catalogue.add({.id = "reweighting/g-1d/stable",
                   .statement = "g in double is within 8 ulp for N up to 10^9 and x from 2^-1074 to 1 − 2^-53.",
                   .source = "[thesis, eq. 4.6]; truth by MPFR",
                   .kind = Kind::bounded,
                   .trial = {within_8_ulp,
                             cell_weight,
                             {{"by-pow", "the formula as printed: the rounding of 1 − x is raised to the power N − 1",
                               by_pow}}}});
    catalogue.add(
        {.id = "reweighting/g-stratified/stable",
         .statement = "g_s in double is within 2 ulp of the exact rational, for N up to 10^9 and every place.",
         .source = "ours, analytic/cell_weight.h; truth in rationals",
         .kind = Kind::bounded,
         .trial = {stratified_within_2_ulp,
                   stratified_cell_weight,
                   {{"g-of-iid-samples", "g_N of i.i.d. samples", cell_weight}}}});
    catalogue.add({.id = "reweighting/g-density/quadrature",
                   .statement = "General g by quadrature is within its derived bound of the closed forms for uniform "
                                "and stepped densities.",
                   .source = "ours, analytic/cell_weight_density.h",
                   .kind = Kind::bounded,
                   .trial = {quadrature_within_its_bound,
                             cell_weight_by_quadrature,
                             {{"n-for-n-minus-1", "N other samples in place of N − 1",
                               [](std::uint64_t n, double x, const Density1D& p, int panels) {
                                   const double scale = static_cast<double>(n) / static_cast<double>(n + 1);
                                   const BoundedValue g = cell_weight_by_quadrature(n + 1, x, p, panels);
                                   return BoundedValue{scale * g.value, scale * g.error};
                               }}}}});
    catalogue.add(
        {.id = "reweighting/yakowitz-trapezoid/lines",
         .statement = "The trapezoidal rule on samples and ends integrates a line within 1e-12, whatever the samples.",
         .source = "[Yakowitz et al. 1978]",
         .kind = Kind::bounded,
         .trial = {
             integrates_lines,
             trapezoid_weights_1d,
             {{"without-the-ends", "the nearest-neighbour rule, ends unused", [](std::span<const double> samples) {
                   Samples weights = voronoi_weights_1d(samples);
                   weights.insert(weights.end(), {0, 0});
                   return weights;
               }}}}});
}

}  // namespace

void add_reweighting_bounded_1d(Catalogue& catalogue) {
    add_cells(catalogue);
    add_formulas(catalogue);
}

}  // namespace plumb::suites
