#include "estimators/reweighting/reweighting_estimators_2d.h"

#include <mutex>

#include "estimators/points/halton.h"
#include "estimators/points/stratified.h"
#include "estimators/reweighting/cell_weight_2d.h"
#include "estimators/reweighting/reweighting_2d.h"

namespace plumb {

const CellWeightTable2D& uniform_cell_weight(std::uint64_t n) {
    static std::mutex mutex;
    static std::map<std::uint64_t, CellWeightTable2D> tables;
    const std::lock_guard lock(mutex);
    return tables.try_emplace(n, n).first->second;
}

namespace {

using Slope2D = std::optional<Interval>;

// Exponents of the MSE, with a quarter to either side for what is not yet asymptotic. A cell at a jump errs by its area
// 1/N, and √N cells lie there: √N · N^-2; at a root by N^-1 · N^-1/4, at a kink by N^-1 · N^-1/2; N cells of a smooth f
// by a second difference each: N · N^-4. docs/statistics.md, "Rates".
constexpr double jump = -1.5, root = -2, kink = -2.5, smooth = -3;

/// The interval between two exponents, the steeper and the flatter.
Interval between(double steep, double flat) {
    return {steep - 0.25, flat + 0.25};
}

double exponent_at(Smoothness smoothness) {
    switch (smoothness) {
        case Smoothness::analytic: return smooth;
        case Smoothness::kink: return kink;
        case Smoothness::root: return root;
        case Smoothness::jump: return jump;
        case Smoothness::singular: return 0;
    }
    throw std::logic_error("a Smoothness outside its enumeration");
}

bool has_slope(const Integrand<2>& f) {
    return f.smoothness != Smoothness::singular && f.variance_value() > 0;
}

/// What counts is the smoothness on the torus, where the interior's defects are seen too.
Slope2D torus_slope(const Integrand<2>& f) {
    if (!has_slope(f)) return {};
    const double exponent = exponent_at(std::max(f.smoothness, f.periodic_smoothness));
    return between(exponent, exponent);
}

/// φ leaves no jump along the boundary, but a kink unless the normal derivative vanishes there.
Slope2D tent_slope(const Integrand<2>& f) {
    if (!has_slope(f)) return {};
    const double exponent = exponent_at(f.smoothness);
    return between(exponent, std::max(exponent, kink));
}

/// The bias of the boundary's cells is of order N^-1, its factor the integral of the normal derivative along the
/// boundary: N^-2 in squares, unless that integral vanishes.
Slope2D clipped_slope(const Integrand<2>& f) {
    if (!has_slope(f)) return {};
    const double exponent = exponent_at(f.smoothness);
    return between(exponent, std::max(exponent, -2.0));
}

/// Divided by g, a boundary cell keeps a random factor of order 1, as at a jump from f to 0 along the boundary: the
/// slope of a jump unless f vanishes there, which a continuous periodic extension allows.
Slope2D divided_slope(const Integrand<2>& f) {
    if (f.smoothness == Smoothness::singular) return {};
    return between(std::max(exponent_at(std::max(f.smoothness, f.periodic_smoothness)), kink), jump);
}

Estimate run_reweighted(const Function<2>& f, std::uint64_t n, RandomStream& random) {
    const std::vector<Point<2>> samples = independent_points<2>(n, random);
    const CellWeightTable2D& g = uniform_cell_weight(n);
    return weighted_sum(f, samples, reweighted_weights_2d(samples, g, [](const Point<2>&) { return 1.0; }));
}

using OnSamples = Estimate (*)(const Function<2>&, std::span<const Point<2>>);

auto on_independent_samples(OnSamples estimate) {
    return [estimate](const Function<2>& f, std::uint64_t n, RandomStream& random) {
        return estimate(f, independent_points<2>(n, random));
    };
}

}  // namespace

std::vector<Estimator<2>> reweighting_estimators_2d() {
    return {
        {.id = "voronoi",
         .summary = "Independent samples weighted by their Voronoi cells, clipped to the square.",
         .source = "[thesis, eq. 4.4]",
         .unbiased = false,
         .run = on_independent_samples(voronoi_estimate),
         .expected_slope = clipped_slope},
        {.id = "voronoi-reweighted",
         .summary = "Independent samples weighted by their clipped Voronoi cells over those cells' expectation g/N.",
         .source = "ours, estimators/reweighting/cell_weight_2d.h; in one dimension [thesis, eq. 4.8]",
         .run = run_reweighted,
         .expected_slope = divided_slope},
        {.id = "torus",
         .summary = "Independent samples weighted by their Voronoi cells on the torus.",
         .source = "ours, estimators/reweighting/reweighting_2d.h",
         .run = on_independent_samples(torus_estimate),
         .expected_slope = torus_slope},
        {.id = "torus-tent",
         .summary = "Torus weights for the integrand folded by the tent map on each axis.",
         .source = "ours, estimators/reweighting/reweighting_2d.h",
         .run = on_independent_samples(torus_tent_estimate),
         .expected_slope = tent_slope},
        {.id = "shifted-torus",
         .summary = "Torus weights on Halton's points after one uniform shift.",
         .source = "ours, estimators/reweighting/reweighting_2d.h",
         .run = [](const Function<2>& f, std::uint64_t n,
                   RandomStream& random) { return shifted_torus_estimate(f, halton_2d(n), random); },
         .expected_slope = [](const Integrand<2>&) { return Slope2D{}; }},
    };
}

}  // namespace plumb
