#pragma once

#include "core/parameters.h"
#include "integrators/drivers/job.h"
#include "integrators/paths/limits.h"

namespace plumb {

/// The names that say how a picture is made: the integrator says what a path is, the driver which paths in which
/// passes, the sampler where random numbers come from. Parameters of all three share one space of names.
struct RenderMethod {
    std::string integrator = "path", driver = "pixels", sampler = "independent";
    PathLimits limits = {};
    ParameterTexts parameters = {};
};

/// The parameters that a method of these names accepts, the integrator's first.
std::vector<Parameter> parameters_of(const RenderMethod& method);

/// The same method with names as lists have them, every parameter at its value, and limits that agree with them
/// (`roulette-start` is limits.roulette_edges). Throws Error for a name, a parameter or a value that is not accepted,
/// and for limits that the integrator does not have.
RenderMethod resolved(RenderMethod method);

/// The estimator of a resolved method.
std::unique_ptr<PathEstimator> estimator_of(const RenderMethod& method);
/// The job of a resolved method, whose sampler replaces that of the settings; the driver learns what it has to learn.
RenderJob job_of(const RenderMethod& method, const Scene& scene, const PathEstimator& estimator,
                 const RenderSettings& settings);

}  // namespace plumb
