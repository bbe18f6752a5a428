#include "integrators/drivers/render.h"

#include <fmt/format.h>

#include <mutex>

#include "core/error.h"
#include "core/parallel.h"
#include "integrators/drivers/sampler.h"
#include "integrators/drivers/splatting.h"

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
    layers[1] = record.first_hit_weight * albedo(first.bsdf);
    layers[2] = record.first_hit_weight * Spectrum::rgb(n.x, n.y, n.z);
    layers[3] = record.first_hit_weight * Spectrum::grey(first.hit.t);
    return layers;
}

// Renders the tiles of one pass into one image. Sums are exact: the order in which tiles and splats come does not
// matter.
class Pass {
public:
    Pass(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings, std::uint32_t number)
        : scene_(scene),
          estimator_(estimator),
          settings_(settings),
          number_(number),
          pixels_({settings.crop.width, settings.crop.height}, render_layers()) {}

    // The rays traced. May be called from several threads, a tile each.
    std::uint64_t render(const FilmRegion& tile) {
        FilmPass part({tile.width, tile.height}, render_layers());
        Sampler sampler(settings_.sampler, settings_.samples_per_pass);
        PathRecord record;
        std::vector<SplatOnPixel> splats;
        for (int y = 0; y < tile.height; ++y)
            for (int x = 0; x < tile.width; ++x) {
                const FilmRegion pixel{tile.x + x, tile.y + y, 1, 1};
                const std::uint32_t first = number_ * settings_.samples_per_pass;
                for (std::uint32_t i = 0; i < settings_.samples_per_pass; ++i) {
                    PrimarySamples& samples = sampler.start(path_key(scene_, settings_, pixel.x, pixel.y, first + i));
                    estimator_.trace(scene_, pixel, samples, record);
                    part.add(x, y, layers_of(record));
                    spread(record, scene_.sensor().filter(), settings_.crop, splats);
                    constexpr std::size_t most_kept = 1 << 14;
                    if (splats.size() >= most_kept) add(splats);
                }
            }
        add(splats);
        const std::lock_guard lock(mutex_);
        pixels_.merge_at(tile.x - settings_.crop.x, tile.y - settings_.crop.y, part);
        return record.rays.count;
    }
    [[nodiscard]] const FilmPass& pixels() const { return pixels_; }

private:
    void add(std::vector<SplatOnPixel>& splats) {
        const std::lock_guard lock(mutex_);
        for (const auto& [x, y, value] : splats) pixels_.splat(x - settings_.crop.x, y - settings_.crop.y, value);
        splats.clear();
    }

    const Scene& scene_;
    const PathEstimator& estimator_;
    const RenderSettings& settings_;
    std::uint32_t number_;
    FilmPass pixels_;
    std::mutex mutex_;
};

}  // namespace

void check_crop(const FilmRegion& crop, FilmSize film) {
    if (crop.width < 1 || crop.height < 1 || crop.x < 0 || crop.y < 0 || crop.width > film.width - crop.x ||
        crop.height > film.height - crop.y)
        throw Error(fmt::format("crop {},{},{},{} of a film of {} x {} pixels: accepted are x,y,width,height within it",
                                crop.x, crop.y, crop.width, crop.height, film.width, film.height));
}

PathKey path_key(const Scene& scene, const RenderSettings& settings, int x, int y, std::uint32_t sample) {
    return {settings.seed, static_cast<std::uint32_t>(y * scene.sensor().film().width + x), sample};
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

RenderSettings part_of(RenderSettings settings, std::uint32_t i, std::uint32_t n) {
    if (n > settings.passes)
        throw Error(
            fmt::format("{} parts of {} passes; accepted are 1 to {} parts", n, settings.passes, settings.passes));
    if (i < 1 || i > n) throw Error(fmt::format("part {} of {}; accepted are 1 to {}", i, n, n));
    settings.first_pass = i - 1;
    settings.pass_step = n;
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
    const std::uint32_t first = settings.first_pass, step = settings.pass_step;
    RenderProgress progress{0, tiles.size() * ((settings.passes - 1 - first) / step + 1)};
    std::mutex mutex;
    for (std::uint32_t pass = first; pass < settings.passes; pass += step) {
        Pass image(scene, estimator, settings, pass);
        bool more = true;
        for_batches(tiles.size(), [&](std::size_t i) {
            const std::uint64_t rays = image.render(tiles[i]);
            const std::lock_guard lock(mutex);
            result.rays += rays;
            ++progress.done;
            if (go_on) more = go_on(progress);
        });
        result.film.add(image.pixels());
        if (!more) break;
    }
    return result;
}

}  // namespace plumb
