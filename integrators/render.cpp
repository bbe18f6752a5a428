#include "integrators/render.h"

#include <fmt/format.h>

#include <mutex>

#include "core/error.h"
#include "core/parallel.h"
#include "integrators/sampler.h"

namespace plumb {

namespace {

constexpr int tile_side = 16;

std::vector<FilmRegion> tiles_of(const FilmRegion& crop) {
    std::vector<FilmRegion> tiles;
    for (int y = 0; y < crop.height; y += tile_side)
        for (int x = 0; x < crop.width; x += tile_side)
            tiles.push_back(
                {crop.x + x, crop.y + y, std::min(tile_side, crop.width - x), std::min(tile_side, crop.height - y)});
    return tiles;
}

std::array<Spectrum, 4> layers_of(const PathRecord& record) {
    std::array<Spectrum, 4> layers{record.sum()};
    if (record.vertices.empty()) return layers;
    const PathVertex& first = record.vertices.front();
    const Vec3 n = first.frame.z;
    layers[1] = albedo(first.bsdf);
    layers[2] = Spectrum::rgb(n.x, n.y, n.z);
    layers[3] = Spectrum::grey(first.hit.t);
    return layers;
}

struct RenderedTile {
    FilmPass pixels;
    std::uint64_t rays;
};

RenderedTile render_tile(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings,
                         const FilmRegion& tile, std::uint32_t pass) {
    RenderedTile result{FilmPass({tile.width, tile.height}, render_layers()), 0};
    Sampler sampler(settings.sampler, settings.samples_per_pass);
    PathRecord record;
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            const FilmRegion pixel{tile.x + x, tile.y + y, 1, 1};
            const auto index = static_cast<std::uint32_t>(pixel.y * scene.sensor().film().width + pixel.x);
            for (std::uint32_t i = 0; i < settings.samples_per_pass; ++i) {
                PrimarySamples& samples = sampler.start({settings.seed, index, pass * settings.samples_per_pass + i});
                estimator.trace(scene, pixel, samples, record);
                result.pixels.add(x, y, layers_of(record));
            }
        }
    result.rays = record.rays.count;
    return result;
}

}  // namespace

void check_crop(const FilmRegion& crop, FilmSize film) {
    if (crop.width < 1 || crop.height < 1 || crop.x < 0 || crop.y < 0 || crop.width > film.width - crop.x ||
        crop.height > film.height - crop.y)
        throw Error(fmt::format("crop {},{},{},{} of a film of {} x {} pixels: accepted are x,y,width,height within it",
                                crop.x, crop.y, crop.width, crop.height, film.width, film.height));
}

RenderSettings with_samples(RenderSettings settings, std::uint32_t samples_per_pixel) {
    if (samples_per_pixel < 1) throw Error("0 samples a pixel; accepted are 1 and more");
    // Of two divisors as near to 16 as each other by ratio, the one with more samples a pass.
    const auto distance = [](std::uint32_t passes) { return std::abs(std::log2(passes / 16.0)); };
    settings.passes = 1;
    for (std::uint32_t passes = 2; passes <= std::min(samples_per_pixel, 256u); ++passes)
        if (samples_per_pixel % passes == 0 && distance(passes) < distance(settings.passes)) settings.passes = passes;
    settings.samples_per_pass = samples_per_pixel / settings.passes;
    return settings;
}

std::vector<FilmLayer> render_layers() {
    return {{"radiance", {"R", "G", "B"}, true},
            {"albedo", {"R", "G", "B"}, true},
            {"normal", {"X", "Y", "Z"}, false},
            {"depth", {"Z"}, true}};
}

Rendered render(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings,
                const std::function<bool(const RenderProgress&)>& go_on) {
    check_crop(settings.crop, scene.sensor().film());
    const std::vector<FilmRegion> tiles = tiles_of(settings.crop);
    const FilmSize size{settings.crop.width, settings.crop.height};
    Rendered result{Film(size, render_layers())};
    RenderProgress progress{0, tiles.size() * settings.passes, false};
    std::mutex mutex;
    for (std::uint32_t pass = 0; pass < settings.passes; ++pass) {
        FilmPass pixels(size, render_layers());
        bool more = true;
        for_batches(tiles.size(), [&](std::size_t i) {
            const FilmRegion& tile = tiles[i];
            const RenderedTile done = render_tile(scene, estimator, settings, tile, pass);
            const std::lock_guard lock(mutex);  // sums are exact: the order in which tiles come does not matter
            pixels.merge_at(tile.x - settings.crop.x, tile.y - settings.crop.y, done.pixels);
            result.rays += done.rays;
            ++progress.done;
            progress.pass_ends = progress.done % tiles.size() == 0;
            if (go_on) more = go_on(progress);
        });
        result.film.add(pixels);
        if (!more) break;
    }
    return result;
}

}  // namespace plumb
