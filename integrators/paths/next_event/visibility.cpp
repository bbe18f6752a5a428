#include "integrators/paths/next_event/visibility.h"

namespace plumb {

namespace {

struct ShadowRays final : Visibility {
    [[nodiscard]] double sample(const Scene& scene, const SurfacePoint& from, const LightSample& end, SampleIndex,
                                Draws&, RayLog& rays) const override {
        return scene.transmittance(from, end, rays);
    }
};

}  // namespace

std::shared_ptr<const Visibility> shadow_rays() {
    static const auto visibility = std::make_shared<const ShadowRays>();
    return visibility;
}

}  // namespace plumb
