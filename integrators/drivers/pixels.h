#pragma once

#include "integrators/drivers/driver.h"

namespace plumb {

/// The driver under which every pixel takes its samples in every pass, independently of the others.
struct IndependentPixels final : Driver {
    [[nodiscard]] std::size_t pieces(const RenderJob& job) const override;
    void make(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image) const override;
    [[nodiscard]] std::optional<double> weight(const RenderJob& job, std::uint32_t pass, int x, int y) const override;
};

}  // namespace plumb
