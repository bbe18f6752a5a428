#pragma once

#include "integrators/drivers/job.h"
#include "integrators/drivers/splatting.h"
#include "integrators/paths/vertex.h"

namespace plumb {

/// The story of one sample of a render: how it came about, and what it adds to the picture.
struct Explanation {
    PathKey key;
    CameraStart start = {};
    PathRecord record = {};
    PathStory story = {};
    double weight = 1;    ///< what the driver lets the sample count; 0 where it does not take it
    Spectrum value = {};  ///< what it adds to its pixel, weighted: 1/spp of it to the mean
    /// What splats anywhere add to the pixels of the crop that they fall on, the sample's own among them: to each the
    /// same 1/spp, shared among all pixels' paths.
    std::vector<SplatOnPixel> splatted = {};

    /// What it adds to all pixels together.
    [[nodiscard]] Spectrum sum() const;
    /// The strategy of a splat that one strategy makes alone; empty for any other splat.
    [[nodiscard]] std::optional<Strategy> strategy_of(std::size_t splat) const;
};

/// The sample of this pixel and index that render() takes for the job, bit by bit. Throws Error for a pixel that is not
/// in the crop, an index that is not below the samples of a pixel, and a driver whose samples have no such numbers.
Explanation explain(const RenderJob& job, int x, int y, std::uint32_t sample);
/// The same for the driver that every render has unless another is asked for.
Explanation explain(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings, int x, int y,
                    std::uint32_t sample);

}  // namespace plumb
