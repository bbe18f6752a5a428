#include "integrators/drivers/explanation.h"

#include <fmt/format.h>

#include "core/error.h"
#include "integrators/drivers/sampler.h"

namespace plumb {

Spectrum Explanation::sum() const {
    Spectrum sum = value;
    for (const SplatOnPixel& splat : splatted) sum += splat.value;
    return sum;
}

std::optional<Strategy> Explanation::strategy_of(std::size_t splat) const {
    std::optional<Strategy> only;
    for (const PathStory::Finding& finding : story.findings) {
        if (finding.splat != splat || is_black(finding.value())) continue;
        if (only) return {};
        only = finding.strategy;
    }
    return only;
}

Explanation explain(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings, int x, int y,
                    std::uint32_t sample) {
    const FilmRegion& crop = settings.crop;
    check_crop(crop, scene.sensor().film());
    if (x < crop.x || y < crop.y || x >= crop.x + crop.width || y >= crop.y + crop.height)
        throw Error(fmt::format("pixel {},{}: accepted are x from {} to {} and y from {} to {}", x, y, crop.x,
                                crop.x + crop.width - 1, crop.y, crop.y + crop.height - 1));
    const std::uint64_t samples_per_pixel = std::uint64_t{settings.samples_per_pass} * settings.passes;
    if (sample >= samples_per_pixel)
        throw Error(fmt::format("sample {} of {} a pixel: accepted are 0 to {}", sample, samples_per_pixel,
                                samples_per_pixel - 1));
    const FilmRegion pixel{x, y, 1, 1};
    Explanation told{.key = path_key(scene, settings, x, y, sample)};
    Sampler sampler(settings.sampler, settings.samples_per_pass);
    PrimarySamples& samples = sampler.start(told.key);
    Draws draws(samples);
    told.start = start_at_camera(scene, pixel, draws);
    told.record.story = &told.story;
    estimator.trace(scene, pixel, samples, told.record);
    told.record.story = nullptr;  // which moves with the explanation
    told.value = told.record.sum();
    spread(told.record, scene.sensor().filter(), crop, told.splatted);
    return told;
}

}  // namespace plumb
