#include "integrators/drivers/pass_image.h"

namespace plumb {

FilmPass& PassImage::made() {
    if (!pixels_) pixels_.emplace(FilmSize{crop_.width, crop_.height}, layers_);
    return *pixels_;
}

void PassImage::add(int x, int y, const FilmPass& part, std::uint64_t rays) {
    const std::lock_guard lock(mutex_);
    made().merge_at(x - crop_.x, y - crop_.y, part);
    rays_ += rays;
}

void PassImage::splat(std::span<const SplatOnPixel> splats) {
    if (splats.empty()) return;
    const std::lock_guard lock(mutex_);
    for (const auto& [x, y, value] : splats) made().splat(x - crop_.x, y - crop_.y, value);
}

const FilmPass& PassImage::pixels() {
    return made();
}

}  // namespace plumb
