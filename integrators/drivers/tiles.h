#pragma once

#include "integrators/drivers/pass_image.h"
#include "integrators/drivers/sampler.h"

namespace plumb {

struct RenderJob;

/// The number of tiles of 16 × 16 pixels that cover a crop, row by row; the last of a row and of a column may be
/// smaller.
std::size_t tile_count(const FilmRegion& crop);
FilmRegion tile_of(const FilmRegion& crop, std::size_t number);
/// The number of the tile that has this pixel of the crop.
std::size_t tile_at(const FilmRegion& crop, int x, int y);

/// The samples of the pixels of a tile in one pass, on their way into the image of the pass.
class TileSamples {
public:
    TileSamples(const RenderJob& job, std::uint32_t pass, const FilmRegion& tile, PassImage& image);

    /// Traces the pixel's samples (x, y on the film), each of which counts with the weight.
    void take(int x, int y, double weight);
    /// Counts as many samples of the pixel as black, and traces none.
    void leave_out(int x, int y);
    /// Hands what has been gathered over to the image.
    void finish();

private:
    void spread_splats(double weight);

    const RenderJob& job_;
    std::uint32_t pass_;
    FilmRegion tile_;
    PassImage& image_;
    FilmPass part_;
    Sampler sampler_;
    PathRecord record_;
    std::vector<SplatOnPixel> splats_;
};

}  // namespace plumb
