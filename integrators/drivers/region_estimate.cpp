#include "integrators/drivers/region_estimate.h"

#include "core/moments.h"
#include "integrators/drivers/sampler.h"
#include "integrators/drivers/splatting.h"

namespace plumb {

Estimate region_estimate(const Scene& scene, const PathEstimator& estimator, const std::string& sampler,
                         const FilmRegion& region, std::uint64_t n, std::uint64_t seed) {
    const auto count = static_cast<std::uint32_t>(n);
    const auto pixel = static_cast<std::uint32_t>(region.y * scene.sensor().film().width + region.x);
    Sampler samples(sampler, count);
    PathRecord record;
    Moments values;
    for (std::uint32_t i = 0; i < count; ++i) {
        estimator.trace(scene, region, samples.start({seed, pixel, i}), record);
        values.add(luminance(region_mean(record, region, scene.sensor().filter())));
    }
    const double error = samples.independent() ? values.standard_error() : std::numeric_limits<double>::infinity();
    return {values.mean(), error, record.rays.count};
}

}  // namespace plumb
