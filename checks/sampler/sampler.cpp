#include "checks/sampler/sampler.h"

#include <fmt/ranges.h>

#include "checks/sampler/density_trial.h"
#include "checks/sampler/values_trial.h"
#include "core/error.h"

namespace plumb::checks {
namespace {

CellDensity density_of(const SamplerTrial& trial) {
    if (is_density_name(trial.density) || !trial.formula) return read_density(trial.density);
    try {
        return trial.formula(trial.density, trial.domain);
    } catch (const Error& error) {
        const std::string why = error.what();
        if (!why.starts_with("formula")) throw;
        throw Error(fmt::format("the density '{}' is no file, has no known name (known: {}) and is no formula: {}",
                                trial.density, fmt::join(density_names(), ", "), why));
    }
}

}  // namespace

Catalogue sampler_catalogue(const SamplerTrial& trial, std::uint64_t seed, double alpha) {
    Catalogue catalogue;
    if (trial.density.empty())
        add_mean(catalogue, trial, seed);
    else if (trial.density == "own")
        add_own_density(catalogue, trial, seed);
    else
        add_density(catalogue, trial, density_of(trial), seed, alpha);
    return catalogue;
}

}  // namespace plumb::checks
