#include "integrators/drivers/explanation.h"

#include <fmt/format.h>

#include "core/error.h"
#include "integrators/drivers/driver.h"
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

namespace {

// What is asked for is there.
void check_sample(const RenderJob& job, int x, int y, std::uint32_t sample) {
    const RenderSettings& settings = job.settings;
    const FilmRegion& crop = settings.crop;
    check_crop(crop, job.scene.sensor().film());
    if (x < crop.x || y < crop.y || x >= crop.x + crop.width || y >= crop.y + crop.height)
        throw Error(fmt::format("pixel {},{}: accepted are x from {} to {} and y from {} to {}", x, y, crop.x,
                                crop.x + crop.width - 1, crop.y, crop.y + crop.height - 1));
    const std::uint64_t samples_per_pixel = std::uint64_t{settings.samples_per_pass} * settings.passes;
    if (sample >= samples_per_pixel)
        throw Error(fmt::format("sample {} of {} a pixel: accepted are 0 to {}", sample, samples_per_pixel,
                                samples_per_pixel - 1));
}

double weight_of(const RenderJob& job, int x, int y, std::uint32_t sample) {
    const auto weight = job.driver->weight(job, sample / job.settings.samples_per_pass, x, y);
    if (!weight)
        throw Error("the driver's paths are not numbered samples of pixels; accepted are drivers whose paths are");
    return *weight;
}

}  // namespace

Explanation explain(const RenderJob& job, int x, int y, std::uint32_t sample) {
    check_sample(job, x, y, sample);
    const Scene& scene = job.scene;
    const RenderSettings& settings = job.settings;
    const FilmRegion pixel{x, y, 1, 1};
    Explanation told{.key = path_key(scene, settings, x, y, sample), .weight = weight_of(job, x, y, sample)};
    Sampler sampler(settings.sampler, settings.samples_per_pass);
    PrimarySamples& samples = sampler.start(told.key);
    Draws draws(samples);
    told.start = start_at_camera(scene, pixel, draws);
    told.record.story = &told.story;
    job.estimator.trace(scene, pixel, samples, told.record);
    told.record.story = nullptr;  // which moves with the explanation
    told.value = told.record.sum() * told.weight;
    spread(told.record, scene.sensor().filter(), settings.crop, told.splatted);
    for (SplatOnPixel& splat : told.splatted) splat.value *= told.weight;
    return told;
}

Explanation explain(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings, int x, int y,
                    std::uint32_t sample) {
    return explain(job_of(scene, estimator, settings), x, y, sample);
}

}  // namespace plumb
