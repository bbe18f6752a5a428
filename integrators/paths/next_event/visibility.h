#pragma once

#include <memory>

#include "integrators/paths/path_estimator.h"

namespace plumb {

/// Says how much of what an end sends arrives at a point: a light's point, or whatever else is connected to it. Any
/// estimate of the right mean will do; its numbers come from Use::visibility of the sample.
struct Visibility {
    virtual ~Visibility() = default;
    /// An estimate whose expectation is Scene::transmittance.
    [[nodiscard]] virtual double sample(const Scene& scene, const SurfacePoint& from, const LightSample& end,
                                        SampleIndex index, Draws& draws, RayLog& rays) const = 0;
};

/// The visibility that is Scene::transmittance itself.
std::shared_ptr<const Visibility> shadow_rays();

}  // namespace plumb
