#include "estimators/reweighting/reweighting_estimators_1d.h"

#include "estimators/densities/density.h"
#include "estimators/replicates/batches.h"
#include "estimators/reweighting/cells_1d.h"
#include "estimators/reweighting/control_variate_line.h"
#include "estimators/reweighting/reweighting_1d.h"
#include "estimators/reweighting/reweighting_slopes_1d.h"
#include "estimators/reweighting/samples_1d.h"
#include "estimators/reweighting/step_density_estimators.h"
#include "estimators/reweighting/tent.h"
#include "estimators/reweighting/warp.h"

namespace plumb {
namespace {

using Samples = std::vector<double> (*)(std::uint64_t, RandomStream&);
using Weights = std::vector<double> (*)(std::span<const double>);
using RunOn = std::function<Estimate(const Function<1>&, std::uint64_t, RandomStream&)>;

Estimate weighted_sum(const Function<1>& f, std::span<const double> samples, std::span<const double> weights) {
    Estimate estimate{.evaluations = samples.size()};
    for (std::size_t i = 0; i < samples.size(); ++i) estimate.value += weights[i] * f({samples[i]});
    return estimate;
}

RunOn cells(Samples draw, Weights weigh) {
    return [draw, weigh](const Function<1>& f, std::uint64_t n, RandomStream& random) {
        const std::vector<double> samples = draw(n, random);
        return weighted_sum(f, samples, weigh(samples));
    };
}

RunOn folded(RunOn run) {
    return [run = std::move(run)](const Function<1>& f, std::uint64_t n, RandomStream& random) {
        return run([&f](const Point<1>& u) { return f(tent(u)); }, n, random);
    };
}

RunOn through_ramp(RunOn run) {
    return
        [run = std::move(run), density = LinearDensity(0.5, 1.5)](
            const Function<1>& f, std::uint64_t n, RandomStream& random) { return run(warped(f, density), n, random); };
}

StepDensity four_steps() {
    return StepDensity::equal_pieces({1, 2, 3, 4});
}

Estimate run_trapezoid(const Function<1>& f, std::uint64_t n, RandomStream& random) {
    std::vector<double> nodes = independent_samples_1d(n, random);
    const std::vector<double> weights = trapezoid_weights_1d(nodes);
    nodes.insert(nodes.end(), {0, 1});
    return weighted_sum(f, nodes, weights);
}

Estimate run_control_variate(const Function<1>& f, std::uint64_t n, RandomStream& random) {
    return control_variate_estimate_1d(f, independent_samples_1d(n, random));
}

}  // namespace

std::vector<Estimator<1>> reweighting_estimators_1d() {
    const RunOn reweighted = cells(independent_samples_1d, reweighted_weights_1d);
    const RunOn torus = cells(independent_samples_1d, torus_weights_1d);
    const RunOn stratified_torus = cells(jittered_samples_1d, torus_weights_1d);
    const RunOn voronoi = cells(independent_samples_1d, voronoi_weights_1d);
    return {
        {"voronoi", "Independent samples weighted with their Voronoi cells, clipped to [0,1].", "[thesis, eq. 4.4]",
         false, voronoi, clipped_slope_1d},
        {"reweighted", "Independent samples, Voronoi cells over their expected length g.", "[thesis, eq. 4.8]", true,
         reweighted, divided_slope_1d},
        {"torus", "Independent samples weighted with their cells on the circle.",
         "ours, estimators/reweighting/cells_1d.h", true, torus, torus_slope_1d},
        {"torus-tent", "Cells on the circle, the integrand folded by the tent map.",
         "ours, estimators/reweighting/tent.h", true, folded(torus), tent_slope_1d},
        {"control-variate-line",
         "Reweighted estimate of f minus the line through its end values, plus the line's integral.",
         "ours, estimators/reweighting/control_variate_line.h", true, run_control_variate, clipped_slope_1d},
        {"stratified-reweighted", "One jittered sample a stratum, Voronoi cells over their expected length.",
         "ours, analytic/cell_weight.h", true, cells(jittered_samples_1d, stratified_reweighted_weights_1d),
         divided_slope_1d},
        {"stratified-torus", "One jittered sample a stratum, cells on the circle.",
         "ours, estimators/reweighting/cells_1d.h", true, stratified_torus, torus_slope_1d},
        {"stratified-torus-tent",
         "One jittered sample a stratum, cells on the circle, the integrand folded by the tent map.",
         "ours, estimators/reweighting/tent.h", true, folded(stratified_torus), tent_slope_1d},
        {"yakowitz-trapezoid", "The trapezoidal rule on independent samples and both ends.", "[Yakowitz et al. 1978]",
         false, run_trapezoid, clipped_slope_1d},
        {"yakowitz-nearest", "The nearest-neighbour rule on independent samples; in one dimension the same as voronoi.",
         "[Yakowitz et al. 1978]", false, voronoi, clipped_slope_1d},
        {"warp-reweighted", "Reweighting in the primary sample of the density p(x) = 1/2 + x.",
         "ours, estimators/reweighting/warp.h", true, through_ramp(reweighted), divided_slope_1d},
        {"warp-torus-tent", "Torus and tent in the primary sample of the density p(x) = 1/2 + x.",
         "ours, estimators/reweighting/warp.h", true, through_ramp(folded(torus)), tent_slope_1d},
        step_reweighted_estimator("density-reweighted", four_steps()),
        step_strata_estimator("piecewise-strata", four_steps()),
        in_batches_of("reweighted-batches-16", Estimator<1>{"reweighted", "", "", true, reweighted, divided_slope_1d},
                      16),
    };
}

}  // namespace plumb
