#pragma once

#include <vector>

#include "estimators/densities/piecewise_constant.h"
#include "scenes/description/mesh.h"
#include "scenes/emitters/area_light.h"

namespace plumb {

/// A triangle with its corners in counterclockwise order as seen from the shining side.
struct Triangle {
    Vec3 a, b, c;
};
std::vector<Triangle> triangles_of(const Mesh& mesh);

/// A point of the triangle with this number, a (1 − b1 − b2) + b b1 + c b2.
struct TrianglePlace {
    std::size_t triangle;
    double b1, b2;
};

/// A surface of triangles, seen from one side.
class MeshSurface {
public:
    /// `largest_margin` is that of the mesh whose triangles these are. Throws Error unless the area is positive and
    /// finite.
    explicit MeshSurface(std::vector<Triangle> triangles, double largest_margin = HUGE_VAL);

    [[nodiscard]] double area() const { return area_; }
    [[nodiscard]] TrianglePlace place(const Point<2>& u) const;
    [[nodiscard]] SurfacePoint at(const Point<2>& u) const;
    /// The first triangle that the ray meets, found by looking at every one: for claims and small lights, as a scene's
    /// ray caster knows the triangle that it met.
    [[nodiscard]] std::optional<PlaneHit> meet(Vec3 from, Vec3 direction) const;

private:
    std::vector<Triangle> triangles_;
    PiecewiseConstant choice_;
    double area_ = 0, largest_margin_;
};

/// A light of triangles that shine to one side.
class MeshLight : public AreaLight<MeshSurface> {
public:
    MeshLight(std::vector<Triangle> triangles, const Spectrum& radiance, double largest_margin = HUGE_VAL)
        : AreaLight(MeshSurface(std::move(triangles), largest_margin), radiance) {}
    static MeshLight of(const Mesh& mesh, const Spectrum& radiance) {
        return {triangles_of(mesh), radiance, mesh.largest_margin};
    }
};
static_assert(LightModel<MeshLight>);

}  // namespace plumb
