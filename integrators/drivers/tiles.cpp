#include "integrators/drivers/tiles.h"

#include "integrators/drivers/job.h"

namespace plumb {

namespace {

constexpr int tile_side = 16;

int tiles_along(int pixels) {
    return (pixels + tile_side - 1) / tile_side;
}

std::array<Spectrum, 4> layers_of(const PathRecord& record, double weight) {
    std::array<Spectrum, 4> layers{record.sum()};
    if (weight != 1) layers[0] *= weight;
    if (record.vertices.empty()) return layers;
    const PathVertex& first = record.vertices.front();
    const Vec3 n = first.frame.z;
    layers[1] = albedo(first.bsdf);
    layers[2] = Spectrum::rgb(n.x, n.y, n.z);
    layers[3] = Spectrum::grey(first.hit.t);
    const double weight_of_first = weight * record.first_hit_weight;
    if (weight_of_first != 1)
        for (std::size_t i = 1; i < layers.size(); ++i) layers[i] *= weight_of_first;
    return layers;
}

}  // namespace

std::size_t tile_count(const FilmRegion& crop) {
    return static_cast<std::size_t>(tiles_along(crop.width)) * static_cast<std::size_t>(tiles_along(crop.height));
}

FilmRegion tile_of(const FilmRegion& crop, std::size_t number) {
    const auto i = static_cast<int>(number);
    const int x = i % tiles_along(crop.width) * tile_side, y = i / tiles_along(crop.width) * tile_side;
    return {crop.x + x, crop.y + y, std::min(tile_side, crop.width - x), std::min(tile_side, crop.height - y)};
}

std::size_t tile_at(const FilmRegion& crop, int x, int y) {
    return static_cast<std::size_t>((y - crop.y) / tile_side * tiles_along(crop.width) + (x - crop.x) / tile_side);
}

TileSamples::TileSamples(const RenderJob& job, std::uint32_t pass, const FilmRegion& tile, PassImage& image)
    : job_(job),
      pass_(pass),
      tile_(tile),
      image_(image),
      part_({tile.width, tile.height}, image.layers()),
      sampler_(job.settings.sampler, job.settings.samples_per_pass) {}

void TileSamples::take(int x, int y, double weight) {
    const std::uint32_t count = job_.settings.samples_per_pass, first = pass_ * count;
    for (std::uint32_t i = 0; i < count; ++i) {
        PrimarySamples& samples = sampler_.start(path_key(job_.scene, job_.settings, x, y, first + i));
        job_.estimator.trace(job_.scene, {x, y, 1, 1}, samples, record_);
        part_.add(x - tile_.x, y - tile_.y, layers_of(record_, weight));
        spread_splats(weight);
    }
}

void TileSamples::leave_out(int x, int y) {
    part_.add_black(x - tile_.x, y - tile_.y, job_.settings.samples_per_pass);
}

void TileSamples::spread_splats(double weight) {
    const std::size_t before = splats_.size();
    spread(record_, job_.scene.sensor().filter(), job_.settings.crop, splats_);
    if (weight != 1)
        for (std::size_t i = before; i < splats_.size(); ++i) splats_[i].value *= weight;
    constexpr std::size_t most_kept = 1 << 14;
    if (splats_.size() < most_kept) return;
    image_.splat(splats_);
    splats_.clear();
}

void TileSamples::finish() {
    image_.splat(splats_);
    splats_.clear();
    image_.add(tile_.x, tile_.y, part_, record_.rays.count);
}

}  // namespace plumb
