#include "integrators/drivers/job.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "core/random.h"
#include "integrators/drivers/pixels.h"
#include "integrators/drivers/sampler.h"
#include "integrators/drivers/splatting.h"

namespace plumb {

namespace {

// The mean luminance of a few paths, or where they bring nothing the scale of the scene's lights; both are in
// proportion to what lights emit. How near it is to the picture's mean does not matter: sums hold 2^-64 to 2^31 of it.
double size_of_radiance(const RenderJob& job) {
    constexpr std::uint32_t paths = 64;
    IndependentSamples numbers;
    PathRecord record;
    double sum = 0;
    for (std::uint32_t i = 0; i < paths; ++i) {
        numbers.start({stream_id("size of radiance"), 0, i});
        job.estimator.trace(job.scene, job.settings.crop, numbers, record);
        const double brings = luminance(region_mean(record, job.settings.crop, job.scene.sensor().filter()));
        if (std::isfinite(brings)) sum += std::abs(brings);
    }
    return sum > 0 ? sum / paths : job.scene.scale_of_light();
}

int exponent_of_radiance(const RenderJob& job) {
    const double size = size_of_radiance(job);
    return size > 0 && std::isfinite(size) ? std::clamp(std::ilogb(size), -900, 900) : 0;
}

RenderSettings cut_near_16(RenderSettings settings, std::uint32_t samples) {
    // Where two divisors are equally near to 16 by ratio, the one with more samples a pass is taken.
    const auto distance = [](std::uint32_t passes) { return std::abs(std::log2(passes / 16.0)); };
    settings.passes = 1;
    for (std::uint32_t passes = 2; passes <= std::min(samples, 256u); ++passes)
        if (samples % passes == 0 && distance(passes) < distance(settings.passes)) settings.passes = passes;
    settings.samples_per_pass = samples / settings.passes;
    return settings;
}

/// The least divisor from 2 on.
std::uint32_t least_factor(std::uint32_t n) {
    for (std::uint32_t i = 2; i * i <= n; ++i)
        if (n % i == 0) return i;
    return n;
}

bool is_prime(std::uint32_t n) {
    return n > 1 && least_factor(n) == n;
}

/// Of a number that is no prime: as many passes as samples in each, or more passes, as nearly as can be.
RenderSettings cut_evenly(RenderSettings settings, std::uint32_t samples) {
    auto points = static_cast<std::uint32_t>(std::sqrt(samples));
    while (samples % points != 0) --points;
    settings.samples_per_pass = points;
    settings.passes = samples / points;
    return settings;
}

}  // namespace

RenderJob job_of(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings) {
    static const auto pixels = std::make_shared<const IndependentPixels>();
    return {scene, estimator, settings, pixels};
}

RenderSettings with_samples(RenderSettings settings, std::uint32_t samples_per_pixel) {
    if (samples_per_pixel < 1) throw Error("0 samples a pixel; accepted are 1 and more");
    settings = cut_near_16(settings, samples_per_pixel);
    const bool sets = !find_sampler(settings.sampler).independent;
    if (!sets || settings.samples_per_pass > 1 || samples_per_pixel < 4) return settings;
    return cut_evenly(settings, is_prime(samples_per_pixel) ? samples_per_pixel + 1 : samples_per_pixel);
}

RenderSettings part_of(RenderSettings settings, std::uint32_t i, std::uint32_t n) {
    if (n > settings.passes)
        throw Error(
            fmt::format("{} parts of {} passes; accepted are 1 to {} parts", n, settings.passes, settings.passes));
    if (i < 1 || i > n) throw Error(fmt::format("part {} of {}; accepted are 1 to {}", i, n, n));
    settings.first_pass = i - 1;
    settings.pass_step = n;
    return settings;
}

PathKey path_key(const Scene& scene, const RenderSettings& settings, int x, int y, std::uint32_t sample) {
    return {settings.seed, static_cast<std::uint32_t>(y * scene.sensor().film().width + x), sample};
}

void check_crop(const FilmRegion& crop, FilmSize film) {
    if (crop.width < 1 || crop.height < 1 || crop.x < 0 || crop.y < 0 || crop.width > film.width - crop.x ||
        crop.height > film.height - crop.y)
        throw Error(fmt::format("crop {},{},{},{} of a film of {} x {} pixels: accepted are x,y,width,height within it",
                                crop.x, crop.y, crop.width, crop.height, film.width, film.height));
}

std::vector<FilmLayer> render_layers(const RenderJob& job) {
    return {{"radiance", {"R", "G", "B"}, true, exponent_of_radiance(job)},
            {"albedo", {"R", "G", "B"}, true},
            {"normal", {"X", "Y", "Z"}, false},
            {"depth", {"Z"}, true}};
}

}  // namespace plumb
