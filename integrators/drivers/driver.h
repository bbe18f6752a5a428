#pragma once

#include <optional>

#include "integrators/drivers/job.h"
#include "integrators/drivers/pass_image.h"

namespace plumb {

/// Decides which paths are traced in a pass, and what they are worth. A pass is a replicate of the whole image (the
/// job's crop), a function of (job, number): its expectation is the picture, and passes of different numbers are
/// independent. Code that renders, cuts into shards, measures errors or makes references counts passes and knows
/// nothing else. A driver learns what it has to learn when it is made, and is frozen then.
struct Driver {
    virtual ~Driver() = default;

    /// The number of pieces of a pass that know nothing of each other, at least 1. A pass whose parts know of each
    /// other is one piece, and may call for_batches itself.
    [[nodiscard]] virtual std::size_t pieces(const RenderJob& job) const = 0;

    /// Adds a piece of a pass to its image. It is called from several threads at once, in any order.
    virtual void make(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image) const = 0;

    /// The weight with which the samples of this pixel, whose numbers are path_key's, count in the pass: 0 where they
    /// are not taken. It is empty where the driver's paths have no such numbers, and cannot be explained one by one.
    [[nodiscard]] virtual std::optional<double> weight(const RenderJob& job, std::uint32_t pass, int x,
                                                       int y) const = 0;
};

}  // namespace plumb
