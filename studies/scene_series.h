#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "verification/run.h"
#include "verification/series.h"

namespace plumb {

/// Which integrators are measured, and against what.
struct SceneMeasure {
    std::vector<std::string> estimators;  ///< INTEGRATOR or INTEGRATOR+SAMPLER
    std::vector<std::uint64_t> n;
    std::uint64_t replicates = 1000;
    std::string reference = {};  ///< a file, or "auto" for the cached one; empty: measured for the purpose
    std::string cache = "out/references";
};

/// Whether this names a scene, or a part of one: SCENE, SCENE:x,y or SCENE:x,y,width,height.
bool names_scene(const std::string& on);

/// Throws Error for a name that is no INTEGRATOR or INTEGRATOR+SAMPLER.
void check_scene_methods(const std::vector<std::string>& estimators);

struct SceneSeries {
    std::vector<Series> series;
    double truth = 0;
    std::string said;  ///< the truth in words
};

/// Error against samples and rays of integrators on a part of a scene: the mean luminance of a pixel, of a tile or of
/// the whole image. The truth is a reference picture, or measured by the first of them with Sobol samples, four times
/// the largest n in each replicate; its own variance is subtracted. Throws Error for a reference that is of another
/// scene, size or length of paths.
SceneSeries measure_scene(const std::string& on, const SceneMeasure& measure, const Run& run);

}  // namespace plumb
