#pragma once

#include <vector>

#include "checks/bsdf/cubature.h"
#include "core/vec3.h"

namespace plumb::checks {

/// The sphere of directions, divided into rectangles of (polar angle, azimuth from the plane of incidence) that grow by
/// factors of 4 with their distance from where a lobe of the given roughness may peak: the mirrored direction, the
/// refracted one, the horizon and the poles.
class SphereGrid {
public:
    /// The grid for a roughness in [1e-6, 1] and the index inside over the index outside, eta > 0. Throws Error for
    /// others.
    SphereGrid(Vec3 wo, double roughness, double eta);

    [[nodiscard]] const std::vector<Rectangle>& rectangles() const { return rectangles_; }
    /// The rectangle that w lies in.
    [[nodiscard]] std::size_t index(Vec3 w) const;
    [[nodiscard]] Vec3 direction(double polar, double azimuth) const;

private:
    std::vector<double> polar_, azimuth_;
    Vec3 forward_;  // horizontal, away from wo
    std::vector<Rectangle> rectangles_;
};

}  // namespace plumb::checks
