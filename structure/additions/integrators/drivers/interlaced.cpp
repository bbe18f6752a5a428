#include "integrators/drivers/interlaced.h"

#include "core/random.h"
#include "integrators/drivers/tiles.h"

namespace plumb {

std::size_t Interlaced::pieces(const RenderJob& job) const {
    return tile_count(job.settings.crop);
}

void Interlaced::make(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image) const {
    make_rows(job, pass, piece, image, [&](int y) { return *weight(job, pass, 0, y); });
}

std::optional<double> Interlaced::weight(const RenderJob& job, std::uint32_t pass, int, int y) const {
    RandomStream random(job.settings.seed ^ stream_id("interlaced"), pass, 0);
    return static_cast<std::uint64_t>(y) % fields == random.below(fields) ? static_cast<double>(fields) : 0;
}

void make_rows(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image,
               const std::function<double(int y)>& weight) {
    const FilmRegion tile = tile_of(job.settings.crop, piece);
    TileSamples samples(job, pass, tile, image);
    for (int y = tile.y; y < tile.y + tile.height; ++y) {
        const double counts = weight(y);
        for (int x = tile.x; x < tile.x + tile.width; ++x) {
            if (counts > 0)
                samples.take(x, y, counts);
            else
                samples.leave_out(x, y);
        }
    }
    samples.finish();
}

std::unique_ptr<Driver> make_interlaced(const RenderJob&, const Parameters& parameters) {
    return std::make_unique<Interlaced>(static_cast<std::uint64_t>(parameters.integer(interlaced_fields.name)));
}

}  // namespace plumb
