// Small things on a ground with a horizon: what a place on the ground sees of a thing nearby does not depend on how far
// the ground goes on.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "estimators/densities/warps.h"
#include "scenes/geometry/embree_scene.h"
#include "scenes/geometry/wide_triangles.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {

namespace {

using description::Shape;
using description::Sphere;

/// The functions on trial: which triangles rays meet in doubles, and how rays start.
struct Grounds {
    std::function<void(std::span<Shape>)> prepare = meet_wide_triangles_in_doubles;
    std::function<Ray(const SurfacePoint&, Vec3)> leaves = leave;
};

struct Counts {
    std::uint64_t rays = 0, lost = 0, misplaced = 0, wrong_shadows = 0;
};

Shape shape_of(auto geometry) {
    return {.geometry = std::move(geometry), .material = {}, .emitter = {}, .id = {}, .place = {}};
}

/// A ball that stands on a square ground, whose vertices are floats: far ones move it off where it was meant to be.
struct BallOnGround {
    double size;                  ///< the ball's radius
    Vec3 normal{}, foot{};        ///< the ground's, and where the ball touches it
    std::array<Shape, 2> shapes;  ///< ground and ball

    BallOnGround(double half_side, double radius, Vec3 near, const Transform& turn) : size(radius) {
        Mesh ground = transformed(rectangle_mesh(), turn * Transform::scale({half_side, half_side, 1}));
        const auto [a, b, c] = ground.corners(0);
        normal = normalize(cross(b - a, c - a));
        foot = near + normal * dot(a - near, normal);
        shapes = {shape_of(std::move(ground)),
                  shape_of(Sphere{.center = centre(), .radius = radius, .flip_normals = false, .to_world = {}})};
    }
    [[nodiscard]] Vec3 centre() const { return foot + normal * size; }
    /// How far a ray passes from the ball's centre, in radii; infinite behind the ray.
    [[nodiscard]] double passes_at(Vec3 from, Vec3 direction) const {
        const Vec3 to = centre() - from;
        return dot(to, direction) > 0 ? length(cross(to, direction)) / size : HUGE_VAL;
    }
};

/// Looks down at places within four radii of the ball, and from each place into a random direction.
void look(const BallOnGround& scene, const Grounds& grounds, int places, RandomStream& random, Counts& counts) {
    std::array<Shape, 2> shapes = scene.shapes;
    grounds.prepare(shapes);
    const EmbreeScene embree(shapes);
    const Frame frame(scene.normal);
    for (int i = 0; i < places; ++i) {
        const double radius = scene.size * (1 + 3 * random.uniform()), angle = 2 * std::numbers::pi * random.uniform();
        const Vec3 place = scene.foot + frame.to_world({radius * std::cos(angle), radius * std::sin(angle), 0});
        const Ray down = rounded_ray(place + scene.normal * (3 * scene.size), -scene.normal);
        const auto hit = embree.intersect(down);
        ++counts.rays;
        if (!hit || hit->shape != 0) {
            counts.lost += scene.passes_at(down.origin, -scene.normal) > 1.01;
            continue;
        }
        const double height = dot(down.origin - scene.foot, scene.normal);
        const Vec3 met = down.origin + down.direction * (height / -dot(down.direction, scene.normal));
        counts.misplaced += length(hit->point.position - met) > 1e-2 * scene.size;
        const Vec3 up = frame.to_world(sample_cosine_hemisphere({random.uniform(), random.uniform()}));
        const double passes = scene.passes_at(hit->point.position, up);
        if (std::abs(passes - 1) < 2e-2) continue;  // rounding may decide
        ++counts.rays;
        counts.wrong_shadows += embree.occluded(grounds.leaves(hit->point, up)) != (passes < 1);
    }
}

/// Grounds of 1 to 10^8, balls of 1 and 10^-3, at the origin and 2^10 radii away, level and turned.
Verdict sees_what_is_near(const Grounds& grounds, const Run& run) {
    Counts counts;
    std::uint64_t number = 0;
    for (const double size : {1.0, 1e-3})
        for (double half_side = 1e4 * size; half_side <= 1.01e8; half_side *= 10)
            for (const double away : {0.0, 0x1p10})
                for (const bool level : {true, false}) {
                    RandomStream random = run.random(number++);
                    const Vec3 axis = sample_uniform_sphere({random.uniform(), random.uniform()});
                    const Transform turn = level ? Transform{} : Transform::rotate(axis, 360 * random.uniform());
                    const Vec3 near = turn.vector(Vec3{0.6, 0.8, 0} * (away * size));
                    look({half_side, size, near, turn}, grounds, run.pick(200, 20'000), random, counts);
                }
    return exactly(counts.lost + counts.misplaced + counts.wrong_shadows == 0, counts.rays,
                   fmt::format("of {} rays {} passed the ground, {} found it elsewhere, {} met or missed the ball "
                               "wrongly",
                               counts.rays, counts.lost, counts.misplaced, counts.wrong_shadows));
}

Ray an_epsilon_off(const SurfacePoint& from, Vec3 direction) {
    const double side = dot(from.normal, direction) < 0 ? -1 : 1;
    return rounded_ray(from.position + from.normal * (side * 1e-4), direction);
}

}  // namespace

void add_surfaces_wide_grounds(Catalogue& catalogue) {
    catalogue.add(
        {.id = "mesh/wide-ground/shadows",
         .statement =
             "A place on a ground of up to 10^8 a side sees a ball of radius 1 or 10^-3 that stands nearby where "
             "it is, at the origin and 2^10 radii away: floats of the place alone decide how near.",
         .source = "ours, scenes/geometry/wide_triangles.h",
         .kind = Kind::exact,
         .trial = {sees_what_is_near,
                   {},
                   {{"in-floats", "every triangle is met in floats", {.prepare = [](std::span<Shape>) {}}},
                    {"fixed-epsilon", "a ray starts 1e-4 off the surface", {.leaves = an_epsilon_off}}}}});
}

}  // namespace plumb::suites
