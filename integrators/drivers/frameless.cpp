#include "integrators/drivers/frameless.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "integrators/drivers/tiles.h"

namespace plumb {

DrawnPixels Frameless::drawn(const RenderJob& job, std::uint32_t pass, std::size_t tile) const {
    const FilmRegion region = tile_of(job.settings.crop, tile);
    const auto n = static_cast<std::uint32_t>(region.width * region.height);
    const auto k = static_cast<std::uint32_t>(std::max(1.0, std::round(share * n)));
    RandomStream random(job.settings.seed ^ stream_id("frameless"), pass, tile);
    DrawnPixels drawn{random_permutation(n, random), static_cast<double>(n) / k};
    drawn.pixels.resize(k);
    return drawn;
}

std::size_t Frameless::pieces(const RenderJob& job) const {
    return tile_count(job.settings.crop);
}

void Frameless::make(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image) const {
    make_drawn(job, pass, tile_of(job.settings.crop, piece), drawn(job, pass, piece), image);
}

std::optional<double> Frameless::weight(const RenderJob& job, std::uint32_t pass, int x, int y) const {
    const std::size_t number = tile_at(job.settings.crop, x, y);
    const FilmRegion tile = tile_of(job.settings.crop, number);
    const DrawnPixels some = drawn(job, pass, number);
    const auto pixel = static_cast<std::uint32_t>((y - tile.y) * tile.width + (x - tile.x));
    return std::ranges::count(some.pixels, pixel) > 0 ? some.weight : 0;
}

void make_drawn(const RenderJob& job, std::uint32_t pass, const FilmRegion& tile, const DrawnPixels& drawn,
                PassImage& image) {
    TileSamples samples(job, pass, tile, image);
    std::vector<bool> taken(static_cast<std::size_t>(tile.width * tile.height));
    const auto x = [&](std::uint32_t pixel) { return tile.x + static_cast<int>(pixel) % tile.width; };
    const auto y = [&](std::uint32_t pixel) { return tile.y + static_cast<int>(pixel) / tile.width; };
    for (const std::uint32_t pixel : drawn.pixels) {
        samples.take(x(pixel), y(pixel), drawn.weight);
        taken[pixel] = true;
    }
    for (std::uint32_t pixel = 0; pixel < taken.size(); ++pixel)
        if (!taken[pixel]) samples.leave_out(x(pixel), y(pixel));
    samples.finish();
}

}  // namespace plumb
