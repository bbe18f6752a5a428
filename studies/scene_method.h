#pragma once

#include <string>

#include "integrators/method.h"

namespace plumb {

/// An estimator of scenes by the name that figures and tables show.
struct SceneMethod {
    std::string id;
    RenderMethod render;  ///< resolved; samples are drawn one by one, without a driver
};

/// The method INTEGRATOR or INTEGRATOR+SAMPLER, all parameters at their defaults. Throws Error.
SceneMethod scene_method(const std::string& id);

/// "path, sobol-owen, roulette-start=5": all that the method is, for tables.
std::string in_words(const SceneMethod& method);

}  // namespace plumb
