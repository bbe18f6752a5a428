#pragma once

#include <span>
#include <vector>

#include "core/error.h"
#include "estimators/densities/piecewise_constant.h"
#include "estimators/densities/warps.h"
#include "scenes/emitters/surface.h"

namespace plumb {

/// Corners in the order that is counter-clockwise as seen from the shining side.
struct Triangle {
    Vec3 a, b, c;
};

/// Triangles that shine to one side with the same radiance; sampled uniformly over their whole area.
class MeshLight {
public:
    MeshLight(std::vector<Triangle> triangles, const Spectrum& radiance)
        : triangles_(std::move(triangles)), radiance_(radiance), choice_(areas(triangles_)) {
        for (const double area : areas(triangles_)) area_ += area;
    }

    [[nodiscard]] std::optional<EmitterSample> sample(Vec3 from, const Point<2>& u) const {
        return sample_towards(from, at(u), radiance_, pdf_area());
    }
    /// Looks at every triangle: for claims and small lights; a scene's ray caster knows the triangle it met, and gets
    /// the density from pdf_area() and per_steradian().
    [[nodiscard]] std::optional<EmitterHit> hit(Vec3 from, Vec3 direction) const {
        std::optional<EmitterHit> nearest;
        for (const Triangle& triangle : triangles_)
            if (const auto one = hit_one(triangle, from, direction);
                one && (!nearest || one->distance < nearest->distance))
                nearest = one;
        return nearest;
    }
    [[nodiscard]] EmittedRay sample_ray(const Ball&, const Point<2>& u, const Point<2>& v) const {
        return send_from(at(u), radiance_, pdf_area(), v);
    }
    [[nodiscard]] EmittedRayPdf ray_pdf(const Ball&, Vec3 normal, Vec3 direction) const {
        return ray_pdf_from(pdf_area(), normal, direction);
    }
    [[nodiscard]] double pdf_area() const { return 1 / area_; }
    [[nodiscard]] Spectrum power(double) const { return lambertian_power(radiance_, area_); }

private:
    [[nodiscard]] SurfacePoint at(const Point<2>& u) const {
        const double count = static_cast<double>(triangles_.size()), place = choice_.sample(u[0]) * count;
        const std::size_t i = std::min(static_cast<std::size_t>(place), triangles_.size() - 1);
        const auto [b1, b2] = sample_uniform_triangle({place - static_cast<double>(i), u[1]});
        const auto& [a, b, c] = triangles_[i];
        return triangle_point(Facet({a, b, c}), b1, b2);
    }

    static std::vector<double> areas(std::span<const Triangle> triangles) {
        std::vector<double> areas;
        double sum = 0;
        for (const auto& [a, b, c] : triangles) sum += areas.emplace_back(length(cross(b - a, c - a)) / 2);
        if (!(sum > 0 && std::isfinite(sum)))
            throw Error(fmt::format("mesh light of {} triangles and area {}: the area must be positive and finite",
                                    triangles.size(), sum));
        return areas;
    }

    [[nodiscard]] std::optional<EmitterHit> hit_one(const Triangle& t, Vec3 from, Vec3 direction) const {
        const Vec3 product = cross(t.b - t.a, t.c - t.a);
        const double twice_area = length(product);
        if (!(twice_area > 0)) return {};
        const Vec3 normal = product / twice_area;
        const auto plane = meet_plane(from, direction, t.a, normal);
        if (!plane) return {};
        const Vec3 p = from + direction * plane->distance - t.a;
        const double b1 = dot(cross(p, t.c - t.a), normal), b2 = dot(cross(t.b - t.a, p), normal);
        if (!(b1 >= 0 && b2 >= 0 && b1 + b2 <= twice_area)) return {};
        return EmitterHit{plane->distance, radiance_, per_steradian(pdf_area(), plane->distance, plane->cos_at_light)};
    }

    std::vector<Triangle> triangles_;
    Spectrum radiance_;
    PiecewiseConstant choice_;
    double area_ = 0;
};
static_assert(EmitterModel<MeshLight>);

}  // namespace plumb
