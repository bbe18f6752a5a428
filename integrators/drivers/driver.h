#pragma once

#include <optional>

#include "integrators/drivers/job.h"
#include "integrators/drivers/pass_image.h"

namespace plumb {

/// Decides which paths are traced in a pass, and what they are worth. A pass is a replicate of the whole image (the
/// job's crop), a function of (job, number): its expectation is the picture, and passes of different numbers are
/// independent. Whoever renders, cuts into shards, measures errors or makes references counts passes and knows nothing
/// else. What a driver learns, it learns when it is made; it is frozen then.
struct Driver {
    virtual ~Driver() = default;

    /// Pieces of a pass that know nothing of each other, at least 1. A pass whose parts do is one piece, and may call
    /// for_batches itself.
    [[nodiscard]] virtual std::size_t pieces(const RenderJob& job) const = 0;

    /// Adds a piece of a pass to its image. Called from several threads at once, in any order.
    virtual void make(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image) const = 0;

    /// What the samples of this pixel, whose numbers are path_key's, count in the pass: 0 where they are not taken.
    /// Empty: the driver's paths have no such numbers, and cannot be explained one by one.
    [[nodiscard]] virtual std::optional<double> weight(const RenderJob& job, std::uint32_t pass, int x,
                                                       int y) const = 0;
};

}  // namespace plumb
