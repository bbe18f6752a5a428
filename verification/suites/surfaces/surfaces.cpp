#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "estimators/densities/warps.h"
#include "scenes/geometry/embree_scene.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {

namespace {

using description::Shape;

/// The functions on trial: how rays start.
struct Starts {
    std::function<Ray(const SurfacePoint&, Vec3)> leaves = leave;
    std::function<Ray(const SurfacePoint&, const SurfacePoint&)> connects = connect;
};

/// A closed convex surface of size 1 about a centre, from random numbers.
using Closed = std::function<Shape(Vec3 center, RandomStream&)>;

Shape shape_of(auto geometry) {
    return {.geometry = std::move(geometry), .material = {}, .emitter = {}, .id = {}, .place = {}};
}

Vec3 uniform_direction(RandomStream& random) {
    return sample_uniform_sphere({random.uniform(), random.uniform()});
}

/// About the normal, down to 1e-4 radians off the surface: beyond that the direction's own rounding decides its side.
Vec3 direction_off(Vec3 normal, RandomStream& random) {
    const double z = 1e-4 + (1 - 1e-4) * random.uniform(), angle = 2 * std::numbers::pi * random.uniform();
    const double r = std::sqrt(1 - z * z);
    return Frame(normal).to_world({r * std::cos(angle), r * std::sin(angle), z});
}

Shape box(Vec3 center, RandomStream&) {
    return shape_of(transformed(cube_mesh(), Transform::translate(center) * Transform::scale({0.5, 0.5, 0.5})));
}

/// Its faces stay planar when its corners are rounded.
Shape tetrahedron_of(Vec3 center, const std::array<Vec3, 4>& corners, const Transform& turn) {
    Mesh mesh;
    for (const Vec3 corner : corners) {
        const Vec3 p = center + turn.vector(corner);
        mesh.positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    return shape_of(std::move(mesh));
}

/// Regular, in a random orientation.
Shape tetrahedron(Vec3 center, RandomStream& random) {
    const Transform turn = Transform::rotate(uniform_direction(random), 360 * random.uniform());
    return tetrahedron_of(center, {{{0.5, 0.5, 0.5}, {0.5, -0.5, -0.5}, {-0.5, 0.5, -0.5}, {-0.5, -0.5, 0.5}}}, turn);
}

/// A turned tetrahedron, two of whose edges are as sharp as is allowed: 54°.
Shape wedge(Vec3 center, RandomStream& random) {
    const Transform turn = Transform::rotate(uniform_direction(random), 360 * random.uniform());
    constexpr double h = 0.6939;  // faces meet at the upper and lower edge at 2 atan(0.5/(h √2)) = 54.0°
    return tetrahedron_of(center, {{{0.5, 0.5, h}, {0.5, -0.5, -h}, {-0.5, 0.5, -h}, {-0.5, -0.5, h}}}, turn);
}

/// 16 segments from pole to pole, 32 around, vertices shared.
Shape tessellated_sphere(Vec3 center, RandomStream&) {
    constexpr std::uint32_t rows = 16, columns = 32;
    Mesh mesh;
    for (std::uint32_t i = 0; i <= rows; ++i) {
        for (std::uint32_t j = 0; j < columns; ++j) {
            const double polar = std::numbers::pi * i / rows, azimuth = 2 * std::numbers::pi * j / columns;
            const Vec3 p =
                center +
                Vec3{std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)} * 0.5;
            mesh.positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        }
    }
    const auto vertex = [](std::uint32_t i, std::uint32_t j) {
        return i == 0 ? 0 : i == rows ? rows * columns : i * columns + j % columns;  // one vertex a pole
    };
    for (std::uint32_t i = 0; i < rows; ++i) {
        for (std::uint32_t j = 0; j < columns; ++j) {
            if (i > 0) mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
            if (i + 1 < rows) mesh.triangles.push_back({vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)});
        }
    }
    return shape_of(std::move(mesh));
}

Shape analytic_sphere(Vec3 center, RandomStream&) {
    return shape_of(description::Sphere{.center = center, .radius = 0.5, .flip_normals = false, .to_world = {}});
}

struct Counts {
    std::uint64_t rays = 0, lost = 0, self = 0;
};

/// Whether the ray came back to where it left: a triangle at all, a sphere before half of its chord.
bool returns(const Shape& shape, const Hit& from, const Ray& ray, const Hit& to) {
    if (std::holds_alternative<Mesh>(shape.geometry)) return to.primitive == from.primitive;
    const double chord = std::abs(dot(from.point.normal, normalize(ray.direction)));  // of a diameter of 1
    return chord > 0.01 && length(to.point.position - from.point.position) < chord / 2;
}

/// The normal on the side from which the ray came.
Vec3 facing(const Hit& hit, const Ray& ray) {
    return dot(hit.point.normal, ray.direction) < 0 ? hit.point.normal : -hit.point.normal;
}

/// Walks from points inside, from hit to hit, four times: each ray must hit, none the surface that it leaves.
void walk(const Shape& shape, Vec3 center, const Starts& starts, int walks, RandomStream& random, Counts& counts) {
    const EmbreeScene scene({&shape, 1});
    for (int i = 0; i < walks; ++i) {
        Ray ray = rounded_ray(center + uniform_direction(random) * (0.2 * random.uniform()), uniform_direction(random));
        std::optional<Hit> hit = scene.intersect(ray);
        ++counts.rays;
        for (int bounce = 0; hit && bounce < 4; ++bounce) {
            const Hit from = *hit;
            ray = starts.leaves(from.point, direction_off(facing(from, ray), random));
            hit = scene.intersect(ray);
            ++counts.rays;
            if (hit) counts.self += returns(shape, from, ray, *hit);
        }
        counts.lost += !hit;
    }
}

/// A point of the triangle that is nearer to an edge, and every other time to two, than the rounding of its place.
SurfacePoint beside_edge(const Mesh& mesh, std::uint32_t primitive, RandomStream& random) {
    const auto& [i, j, k] = mesh.triangles[primitive];
    const std::array<Vec3, 3> corners{mesh.position(i), mesh.position(j), mesh.position(k)};
    const double reach = 0x1p-22 * (length(corners[0]) + length(corners[1] - corners[0]));
    const std::size_t edge = random.below(3);
    std::array<double, 3> b;
    b[edge] = reach * random.uniform();
    b[(edge + 1) % 3] = random.uniform() < 0.5 ? reach * random.uniform() : (1 - b[edge]) * random.uniform();
    b[(edge + 2) % 3] = 1 - b[edge] - b[(edge + 1) % 3];
    return triangle_point(Facet(corners), b[1], b[2]);
}

/// Whether the direction is within 1/16 radian of any edge's: docs/scenes.md says why Embree may lose such a ray beside
/// it.
bool along_an_edge(const Mesh& mesh, Vec3 direction) {
    return std::ranges::any_of(mesh.triangles, [&](const auto& triangle) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 edge = mesh.position(triangle[(i + 1) % 3]) - mesh.position(triangle[i]);
            if (length(cross(normalize(edge), direction)) < 1.0 / 16) return true;
        }
        return false;
    });
}

/// Inwards from beside edges and corners, not along them: each ray must hit, none the face that it leaves.
void leave_edges(const Shape& shape, Vec3 center, const Starts& starts, int rays, RandomStream& random,
                 Counts& counts) {
    const EmbreeScene scene({&shape, 1});
    const Mesh& mesh = std::get<Mesh>(shape.geometry);
    for (int i = 0; i < rays; ++i) {
        const auto primitive = static_cast<std::uint32_t>(random.below(mesh.triangles.size()));
        const SurfacePoint from = beside_edge(mesh, primitive, random);
        const Vec3 inside = dot(center - from.position, from.normal) > 0 ? from.normal : -from.normal;
        const Vec3 direction = direction_off(inside, random);
        if (along_an_edge(mesh, direction)) continue;
        const auto hit = scene.intersect(starts.leaves(from, direction));
        ++counts.rays;
        counts.lost += !hit;
        counts.self += hit && hit->primitive == primitive;
    }
}

/// Connects pairs of hits seen from one point inside: nothing lies between, and neither end hides itself.
void connect_pairs(const Shape& shape, Vec3 center, const Starts& starts, int pairs, RandomStream& random,
                   Counts& counts) {
    const EmbreeScene scene({&shape, 1});
    for (int i = 0; i < pairs; ++i) {
        const auto a = scene.intersect(rounded_ray(center, uniform_direction(random)));
        const auto b = scene.intersect(rounded_ray(center, uniform_direction(random)));
        if (!a || !b || std::abs(dot(a->point.normal, b->point.normal)) > 1 - 1e-6) continue;  // on one plane
        ++counts.rays;
        counts.self += scene.occluded(starts.connects(a->point, b->point));
    }
}

/// The verdict on counts at 0 and at 2^0 … 2^12 sizes from the world's origin, in random directions and along the axes.
template <class Count>
Verdict at_all_distances(const Closed& closed, const Run& run, const Count& count) {
    Counts counts;
    for (int exponent = -1; exponent <= 12; ++exponent) {
        for (int place = 0; place < 8; ++place) {
            RandomStream random = run.random(static_cast<std::uint64_t>(8 * (exponent + 1) + place));
            const double distance = exponent < 0 ? 0 : std::exp2(exponent);
            const Vec3 along = place == 0 ? Vec3{1, 0, 0} : place == 1 ? Vec3{0, 0, -1} : uniform_direction(random);
            const Vec3 center = along * distance;
            count(closed(center, random), center, run.pick(100, 2000), random, counts);
        }
    }
    return exactly(counts.lost == 0 && counts.self == 0, counts.rays,
                   fmt::format("{} of {} rays were lost, {} met the surface that they left", counts.lost, counts.rays,
                               counts.self));
}

Verdict closed(const Closed& surface, const Starts& starts, const Run& run) {
    return at_all_distances(surface, run,
                            [&](const Shape& shape, Vec3 center, int n, RandomStream& random, Counts& counts) {
                                walk(shape, center, starts, n, random, counts);
                            });
}

Verdict closed_at_edges(const Closed& surface, const Starts& starts, const Run& run) {
    return at_all_distances(surface, run,
                            [&](const Shape& shape, Vec3 center, int n, RandomStream& random, Counts& counts) {
                                leave_edges(shape, center, starts, 20 * n, random, counts);
                            });
}

Verdict sees_itself(const Closed& surface, const Starts& starts, const Run& run) {
    return at_all_distances(surface, run,
                            [&](const Shape& shape, Vec3 center, int n, RandomStream& random, Counts& counts) {
                                connect_pairs(shape, center, starts, 8 * n, random, counts);
                            });
}

/// Two plates of side 1, 1e-3 apart: what leaves one inwards meets the other.
Verdict gap(const Starts& starts, const Run& run) {
    Counts counts;
    for (int exponent = 0; exponent <= 12; ++exponent) {
        RandomStream random = run.random(static_cast<std::uint64_t>(exponent));
        const double z = std::exp2(exponent);
        const auto plate = [&](double height) {
            return shape_of(transformed(rectangle_mesh(),
                                        Transform::translate({0, 0, height}) * Transform::scale({0.5, 0.5, 0.5})));
        };
        const std::array<Shape, 2> plates{plate(z), plate(z + 1e-3)};
        const EmbreeScene scene(plates);
        for (int i = 0; i < run.pick(1000, 100'000); ++i) {
            const Vec3 start{0.9 * random.uniform() - 0.45, 0.9 * random.uniform() - 0.45, z};
            const bool upwards = random.uniform() < 0.5;
            const Vec3 down = upwards ? Vec3{0, 0, -1} : Vec3{0, 0, 1};
            const auto below = scene.intersect(rounded_ray({start.x, start.y, z - down.z}, down));
            if (!below) continue;
            const Vec3 inwards = direction_off(down, random);
            if (std::abs(inwards.z) < 0.1) continue;  // would leave by the side
            // Through to the plate's other face, and on: from there the other plate is next.
            const auto met = scene.intersect(starts.leaves(below->point, inwards));
            ++counts.rays;
            counts.lost += !met || met->shape == below->shape;
        }
    }
    return exactly(counts.lost == 0, counts.rays,
                   fmt::format("{} of {} rays passed the other plate", counts.lost, counts.rays));
}

// Mutants ------------------------------------------------------------------------------------------------------------

Vec3 side(const SurfacePoint& from, Vec3 direction) {
    return dot(from.normal, direction) < 0 ? -from.normal : from.normal;
}

Ray no_offset(const SurfacePoint& from, Vec3 direction) {
    return rounded_ray(from.position, direction);
}
Ray wrong_side(const SurfacePoint& from, Vec3 direction) {
    return rounded_ray(ray_origin(from, -direction), direction);
}
auto fixed_epsilon(double epsilon) {
    return [=](const SurfacePoint& from, Vec3 direction) {
        return rounded_ray(from.position + side(from, direction) * epsilon, direction);
    };
}
/// 0: not at all, 1: as far as it should be.
auto inset_by(double share) {
    return [=](SurfacePoint from, Vec3 direction) {
        from.inset = from.position + (from.inset - from.position) * share;
        return leave(from, direction);
    };
}
Ray far_end_not_lifted(const SurfacePoint& from, const SurfacePoint& to) {
    const Vec3 origin = ray_origin(from, to.position - from.position);
    return rounded_ray(origin, to.position - origin, 1);
}
Ray near_end_not_lifted(const SurfacePoint& from, const SurfacePoint& to) {
    const Vec3 target = ray_origin(to, from.position - to.position);
    const Vec3 origin = rounded_ray(from.position, {}).origin;
    return rounded_ray(origin, target - origin, 1);
}

const std::string source = "ours, scenes/geometry/surface_point.h";

void add_closed(Catalogue& catalogue) {
    struct Subject {
        std::string id, name;
        Closed surface;
    };
    const std::vector<Subject> subjects{{"box", "a box", box},
                                        {"tetrahedron", "a turned tetrahedron", tetrahedron},
                                        {"tessellated-sphere", "a sphere of triangles", tessellated_sphere},
                                        {"sphere", "a sphere", analytic_sphere}};
    for (const auto& [id, name, surface] : subjects) {
        catalogue.add(
            {.id = "mesh/" + id + "/closed",
             .statement = "Every ray from inside " + name +
                          " hits it, and none hits the surface that it leaves, up "
                          "to 2^12 sizes from the world's origin.",
             .source = source,
             .kind = Kind::exact,
             .trial = {[=](const Starts& starts, const Run& run) { return closed(surface, starts, run); },
                       {},
                       {{"no-offset", "a ray starts at the point rounded to floats", {.leaves = no_offset}},
                        {"fixed-epsilon",
                         "a ray starts 1e-4 off the surface wherever it lies",
                         {.leaves = fixed_epsilon(1e-4)}},
                        {"wrong-side", "a ray starts behind the surface that it leaves", {.leaves = wrong_side}}}}});
        if (id == "tessellated-sphere")
            continue;  // rounding its vertices makes it bumpy: neighbours may hide each other
        catalogue.add(
            {.id = "mesh/" + id + "/sees-itself",
             .statement = "Two points of the inside of " + name +
                          " see each other, up to 2^12 sizes from the "
                          "world's origin: neither end of a shadow ray hides itself.",
             .source = source,
             .kind = Kind::exact,
             .trial = {
                 [=](const Starts& starts, const Run& run) { return sees_itself(surface, starts, run); },
                 {},
                 {{"far-end-not-lifted", "a shadow ray ends on the surface", {.connects = far_end_not_lifted}},
                  {"near-end-not-lifted", "a shadow ray starts on the surface", {.connects = near_end_not_lifted}}}}});
    }
}

void add_plates(Catalogue& catalogue) {
    catalogue.add(
        {.id = "mesh/wedge/edges",
         .statement = "Every ray that leaves a tetrahedron with edges of 54° inwards from beside an edge or a "
                      "corner, and not along an edge, hits another face, up to 2^12 sizes from the world's origin.",
         .source = source,
         .kind = Kind::exact,
         .trial = {[=](const Starts& starts, const Run& run) { return closed_at_edges(wedge, starts, run); },
                   {},
                   {{"no-inset", "a ray starts as near to an edge as its point lies", {.leaves = inset_by(0)}},
                    {"half-inset", "a ray starts half as far from an edge as it should", {.leaves = inset_by(0.5)}},
                    {"no-offset", "a ray starts at the point rounded to floats", {.leaves = no_offset}},
                    {"fixed-epsilon",
                     "a ray starts 1e-4 along the normal from the point",
                     {.leaves = fixed_epsilon(1e-4)}}}}});
    catalogue.add(
        {.id = "mesh/plates/gap",
         .statement =
             "A ray that leaves a plate of side 1 meets the plate 1e-3 away, up to 2^12 sizes from the world's "
             "origin.",
         .source = source,
         .kind = Kind::exact,
         .trial = {gap,
                   {},
                   {{"fixed-epsilon", "a ray starts 2e-3 off the surface", {.leaves = fixed_epsilon(2e-3)}},
                    {"no-offset", "a ray starts at the point rounded to floats", {.leaves = no_offset}}}}});
}

}  // namespace

void add_surfaces_surfaces(Catalogue& catalogue) {
    add_closed(catalogue);
    add_plates(catalogue);
}

}  // namespace plumb::suites
