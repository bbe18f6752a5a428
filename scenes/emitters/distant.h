#pragma once

#include "estimators/densities/warps.h"
#include "scenes/emitters/light.h"

namespace plumb {

// All environments share what follows.

/// The ray of an environment's sample: it starts on the disk that touches the scene's ball there and faces it.
inline EmittedRay send_from_afar(const Ball& scene, const LightSample& sample, const Point<2>& u) {
    const Point<2> p = sample_concentric_disk(u);
    const Vec3 local{scene.radius * p[0], scene.radius * p[1], scene.radius};
    const double pdf_area = 1 / (pi * scene.radius * scene.radius);
    return {scene.centre + Frame(sample.direction).to_world(local),
            -sample.direction,
            sample.radiance / (pdf_area * sample.pdf),
            {pdf_area, sample.pdf}};
}

/// The density of a ray that comes from where an environment's samples have the density `pdf`, per steradian.
inline EmittedRayPdf ray_pdf_from_afar(const Ball& scene, double pdf) {
    return {1 / (pi * scene.radius * scene.radius), pdf};
}

}  // namespace plumb
