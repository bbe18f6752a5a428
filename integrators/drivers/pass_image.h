#pragma once

#include <mutex>
#include <optional>
#include <span>

#include "integrators/drivers/splatting.h"
#include "scenes/film/film.h"

namespace plumb {

/// The image of one pass while its pieces are made, on several threads. Sums are exact: the order in which parts and
/// splats come does not matter.
class PassImage {
public:
    PassImage(const FilmRegion& crop, std::vector<FilmLayer> layers) : crop_(crop), layers_(std::move(layers)) {}
    [[nodiscard]] const std::vector<FilmLayer>& layers() const { return layers_; }

    /// Adds a part, its upper left corner at this pixel of the film, and the rays that it took.
    void add(int x, int y, const FilmPass& part, std::uint64_t rays);
    /// Adds light to pixels of the crop, each value divided by the number of paths that bring some for each sample.
    void splat(std::span<const SplatOnPixel> splats);

    /// All that was added, to be asked when no thread adds any more.
    [[nodiscard]] const FilmPass& pixels();
    [[nodiscard]] std::uint64_t rays() const { return rays_; }

private:
    FilmPass& made();

    FilmRegion crop_;
    std::vector<FilmLayer> layers_;
    std::mutex mutex_;
    std::optional<FilmPass> pixels_;  // when the first part comes: the pass that is begun next costs nobody a wait
    std::uint64_t rays_ = 0;
};

}  // namespace plumb
