#include "estimators/reweighting/step_density_estimators.h"

#include "estimators/replicates/independent_slope.h"
#include "estimators/reweighting/piecewise_strata.h"
#include "estimators/reweighting/reweighting_1d.h"
#include "estimators/reweighting/reweighting_slopes_1d.h"
#include "estimators/reweighting/samples_1d.h"

namespace plumb {
namespace {

std::vector<double> samples_of(const StepDensity& density, std::uint64_t n, RandomStream& random) {
    std::vector<double> samples = independent_samples_1d(n, random);
    for (double& x : samples) x = density.sample(x);
    return samples;
}

}  // namespace

Estimator<1> step_importance_estimator(std::string id, StepDensity density) {
    auto run = [density = std::move(density)](const Function<1>& f, std::uint64_t n, RandomStream& random) {
        Estimate estimate{.evaluations = n};
        for (const double x : samples_of(density, n, random))
            estimate.value += f({x}) / (density.pdf(x) * static_cast<double>(n));
        return estimate;
    };
    return {std::move(id),         "The mean of f/p over independent samples of a piecewise-constant density p.",
            "importance sampling", true,
            std::move(run),        independent_slope<1>};
}

Estimator<1> step_strata_estimator(std::string id, StepDensity density) {
    auto run = [density = std::move(density)](const Function<1>& f, std::uint64_t n, RandomStream& random) {
        return piecewise_strata_estimate(f, density, stratum_counts(density, n), random);
    };
    return {std::move(id),
            "Samples of a piecewise-constant density, fixed counts a piece, each piece reweighted by itself.",
            "[thesis, section 4.4.4]",
            true,
            std::move(run),
            stepped_density_slope_1d};
}

Estimator<1> step_reweighted_estimator(std::string id, StepDensity density) {
    auto run = [density = std::move(density)](const Function<1>& f, std::uint64_t n, RandomStream& random) {
        const std::vector<double> samples = samples_of(density, n, random);
        const std::vector<double> weights = density_reweighted_weights_1d(samples, density);
        Estimate estimate{.evaluations = n};
        for (std::size_t i = 0; i < samples.size(); ++i) estimate.value += weights[i] * f({samples[i]});
        return estimate;
    };
    return {std::move(id),
            "Samples of a piecewise-constant density p, Voronoi cells over g p.",
            "ours, analytic/cell_weight_density.h",
            true,
            std::move(run),
            stepped_density_slope_1d};
}

}  // namespace plumb
