#pragma once

#include <functional>

#include "integrators/drivers/driver.h"

namespace plumb {

/// A finished render: its film, and the rays that it took.
struct Rendered {
    Film film;
    std::uint64_t rays = 0;
};

/// The progress of a render: the pieces that are done, and the pieces of all passes.
struct RenderProgress {
    std::uint64_t done, total;
};

/// Renders the job's passes. `go_on` hears of each piece and of each pass that enters the film, one call at a time;
/// when it answers false to a pass, the render ends with it. Passes enter in order, and overlap: no thread waits for
/// the last piece of one. The same settings give the same bits on any number of threads.
Rendered render(const RenderJob& job, const std::function<bool(const RenderProgress&)>& go_on = {});

/// Renders with the driver that every render has unless another is asked for.
Rendered render(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings,
                const std::function<bool(const RenderProgress&)>& go_on = {});

}  // namespace plumb
