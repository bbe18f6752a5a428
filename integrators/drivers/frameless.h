#pragma once

#include <span>

#include "integrators/drivers/driver.h"

namespace plumb {

/// The k drawn pixels of a tile's n, and the weight n/k of their samples, so that the expectation is that of all.
struct DrawnPixels {
    std::vector<std::uint32_t> pixels;  ///< numbers within the tile, row by row, in the order in which they are drawn
    double weight;
};

/// Frameless rendering: a pass draws some of the pixels of each tile in random order, and takes samples of these alone
/// [Bishop et al. 1994]. A pixel is drawn with probability k/n, and its samples are divided by it, so that each pass is
/// unbiased. Which pixels are drawn is a function of (seed, pass, tile).
struct Frameless final : Driver {
    double share;  ///< of a tile's pixels, in (0, 1]; rounded to whole pixels, at least one

    explicit Frameless(double share_of_pixels) : share(share_of_pixels) {}

    /// The pixels that the pass draws of a tile.
    [[nodiscard]] DrawnPixels drawn(const RenderJob& job, std::uint32_t pass, std::size_t tile) const;

    [[nodiscard]] std::size_t pieces(const RenderJob& job) const override;
    void make(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image) const override;
    [[nodiscard]] std::optional<double> weight(const RenderJob& job, std::uint32_t pass, int x, int y) const override;
};

/// Makes a piece of a pass that takes those pixels' samples, weighted, and leaves out the others.
void make_drawn(const RenderJob& job, std::uint32_t pass, const FilmRegion& tile, const DrawnPixels& drawn,
                PassImage& image);

}  // namespace plumb
