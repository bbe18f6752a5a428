#pragma once

#include <string>
#include <vector>

#include "cli/options.h"
#include "verification/run.h"
#include "verification/series.h"

namespace plumb {

/// Whether --on names a scene, or a part of one: SCENE, SCENE:x,y or SCENE:x,y,width,height.
bool names_scene(const std::string& on);

/// Throws Error for a name that is no INTEGRATOR or INTEGRATOR+SAMPLER.
void check_scene_methods(const std::vector<std::string>& estimators);

struct SceneSeries {
    std::vector<Series> series;
    std::string truth;  ///< in words
};

/// Error against samples and rays of integrators on a part of a scene: the mean luminance of a pixel, of a tile or of
/// the whole image. An estimator is INTEGRATOR or INTEGRATOR+SAMPLER. The truth is a reference picture, or measured by
/// the first of them with Sobol samples, four times the largest n in each replicate; its own variance is subtracted.
/// Throws Error for a reference that is of another scene, size or length of paths.
SceneSeries converge_on_scene(const std::string& on, const ConvergeOptions& options, const Run& run);

}  // namespace plumb
