#include "integrators/drivers/pixels.h"

#include "integrators/drivers/tiles.h"

namespace plumb {

std::size_t IndependentPixels::pieces(const RenderJob& job) const {
    return tile_count(job.settings.crop);
}

void IndependentPixels::make(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image) const {
    const FilmRegion tile = tile_of(job.settings.crop, piece);
    TileSamples samples(job, pass, tile, image);
    for (int y = tile.y; y < tile.y + tile.height; ++y)
        for (int x = tile.x; x < tile.x + tile.width; ++x) samples.take(x, y, 1);
    samples.finish();
}

std::optional<double> IndependentPixels::weight(const RenderJob&, std::uint32_t, int, int) const {
    return 1;
}

}  // namespace plumb
