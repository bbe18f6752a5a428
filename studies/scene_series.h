#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "studies/scene_method.h"
#include "studies/scene_part.h"
#include "verification/run.h"
#include "verification/series.h"

namespace plumb {

/// Which methods are measured, and against what.
struct SceneMeasure {
    std::vector<SceneMethod> methods;
    std::vector<std::uint64_t> n;
    std::uint64_t replicates = 1000;
    std::string reference = {};  ///< a file, or "auto" for the cached one; empty: measured for the purpose
    std::string cache = "out/references";
};

struct SceneSeries {
    std::vector<Series> series;
    double truth = 0;
    std::string said;  ///< the truth in words
};

/// Error against samples and rays of methods on a part of a scene. The truth is a reference picture, or measured by the
/// first of them with Sobol samples, four times the largest n in each replicate; its own variance is subtracted. Throws
/// Error for a reference that is of another scene, size or length of paths.
SceneSeries measure_scene(const ScenePart& part, const SceneMeasure& measure, const Run& run);

}  // namespace plumb
