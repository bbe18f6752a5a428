#pragma once

#include "core/error.h"
#include "scenes/description/mesh.h"
#include "scenes/emitters/area_light.h"

namespace plumb {

/// A rectangle or parallelogram corner + s·edge_1 + t·edge_2, s and t in [0,1], seen from the side of edge_1 × edge_2.
class RectangleSurface {
public:
    RectangleSurface(Vec3 corner, Vec3 edge_1, Vec3 edge_2, double largest_margin)
        : corner_(corner),
          edge_1_(edge_1),
          edge_2_(edge_2),
          halves_{Facet({corner, corner + edge_1, corner + edge_1 + edge_2}, largest_margin),
                  Facet({corner, corner + edge_1 + edge_2, corner + edge_2}, largest_margin)} {
        const Vec3 product = cross(edge_1, edge_2);
        area_ = length(product);
        if (!(area_ > 0 && std::isfinite(area_)))
            throw Error(fmt::format("rectangle light of area {}: it must be positive and finite", area_));
        normal_ = product / area_;
    }

    [[nodiscard]] double area() const { return area_; }
    [[nodiscard]] SurfacePoint at(const Point<2>& u) const {
        const auto& [s, t] = u;
        return s >= t ? triangle_point(halves_[0], s - t, t) : triangle_point(halves_[1], s, t - s);
    }
    [[nodiscard]] std::optional<PlaneHit> meet(Vec3 from, Vec3 direction) const {
        const auto plane = meet_plane(from, direction, corner_, normal_);
        if (!plane) return {};
        const Vec3 p = from + direction * plane->distance - corner_;
        const double s = dot(cross(p, edge_2_), normal_) / area_, t = dot(cross(edge_1_, p), normal_) / area_;
        if (!(0 <= s && s <= 1 && 0 <= t && t <= 1)) return {};
        return plane;
    }

private:
    Vec3 corner_, edge_1_, edge_2_, normal_;
    std::array<Facet, 2> halves_;  // as rays meet it: two triangles, whose common side leaves the corner
    double area_;
};

/// A rectangle or parallelogram that shines to the side of edge_1 × edge_2.
class RectangleLight : public AreaLight<RectangleSurface> {
public:
    /// `largest_margin` is that of the mesh that the rectangle is.
    RectangleLight(Vec3 corner, Vec3 edge_1, Vec3 edge_2, const Spectrum& radiance, double largest_margin = HUGE_VAL)
        : AreaLight({corner, edge_1, edge_2, largest_margin}, radiance) {}
    /// The light that a mesh of two triangles is where they are halves of one parallelogram; empty for any other mesh.
    static std::optional<RectangleLight> of(const Mesh& mesh, const Spectrum& radiance);
};
static_assert(LightModel<RectangleLight>);

}  // namespace plumb
