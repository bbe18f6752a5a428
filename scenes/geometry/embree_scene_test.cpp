#include "scenes/geometry/embree_scene.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace plumb {
namespace {

using description::Disk;
using description::Shape;
using description::Sphere;

Shape shape_of(auto geometry) {
    return {.geometry = std::move(geometry), .material = {}, .emitter = {}, .id = {}, .place = {"scene.xml", 7}};
}

TEST(EmbreeScene, FindsTheNearestShape) {
    const std::vector<Shape> shapes{
        shape_of(Sphere{.center = {0, 0, 5}, .radius = 1, .flip_normals = false, .to_world = {}}),
        shape_of(Disk{.center = {0, 0, 2}, .axis_x = {0.5, 0, 0}, .axis_y = {0, 2, 0}, .normal = {0, 0, 1}}),
        shape_of(transformed(rectangle_mesh(), Transform::translate({0, 0, 8}) * Transform::scale({9, 9, 1})))};
    const EmbreeScene scene(shapes);
    const auto along = [&](Vec3 origin) { return scene.intersect(rounded_ray(origin, {0, 0, 1})); };
    EXPECT_EQ(along({0.25, 1.5, 0}).value().shape, 1u);  // within the ellipse
    EXPECT_EQ(along({0.75, 0, 0}).value().shape, 0u);    // beside it, on the sphere
    EXPECT_EQ(along({0.75, 1.5, 0}).value().shape, 2u);  // beside both
    EXPECT_FALSE(along({10, 0, 0}));
    EXPECT_TRUE(scene.occluded(rounded_ray({0, 0, 0}, {0, 0, 1}, 2.5)));
    EXPECT_FALSE(scene.occluded(rounded_ray({0, 0, 0}, {0, 0, 1}, 1.5)));
    const Hit hit = along({4.5, 0, 0}).value();
    EXPECT_NEAR(hit.uv[0], 0.75, 1e-6);
    EXPECT_NEAR(hit.uv[1], 0.5, 1e-6);
    EXPECT_DOUBLE_EQ(hit.point.position.z, 8);
}

TEST(EmbreeScene, SphereHitsAreExactInDouble) {
    const Vec3 center{1000.1, -2000.2, 3000.3};
    const std::vector<Shape> shapes{
        shape_of(Sphere{.center = center, .radius = 0.7, .flip_normals = false, .to_world = {}})};
    const EmbreeScene scene(shapes);
    RandomStream random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 origin = center + Vec3{3 * random.uniform() - 1.5, 3 * random.uniform() - 1.5, -4};
        const Ray ray = rounded_ray(origin, {0.1 * random.uniform(), 0, 1});
        const auto hit = scene.intersect(ray);
        if (!hit) continue;
        EXPECT_NEAR(length(hit->point.position - center), 0.7, 2e-12);
        EXPECT_NEAR(length(ray.origin + ray.direction * hit->t - hit->point.position), 0, 2e-12);
    }
}

TEST(EmbreeScene, KnowsPlacesOnTinyTriangles) {
    const double size = 0x1p-34;
    const std::vector<Shape> shapes{shape_of(transformed(rectangle_mesh(), Transform::scale({size, size, size})))};
    const Ray ray = rounded_ray({-0.25 * size, 0.5 * size, 0.01 * size}, {1, 0, -0.01});
    const Hit hit = EmbreeScene(shapes).intersect(ray).value();
    EXPECT_NEAR(hit.point.position.x / size, 0.75, 1e-5);
    EXPECT_NEAR(hit.point.position.y / size, 0.5, 1e-5);
}

TEST(EmbreeScene, NormalsFaceAsTheShadingNormalsDo) {
    Mesh mesh = rectangle_mesh();
    mesh.normals.assign(4, {0, 0, -1});
    const std::vector<Shape> shapes{shape_of(mesh)};
    const Hit hit = EmbreeScene(shapes).intersect(rounded_ray({0.1, 0.2, 3}, {0, 0, -1})).value();
    EXPECT_EQ(hit.shading_normal, (Vec3{0, 0, -1}));
    EXPECT_EQ(hit.point.normal, (Vec3{0, 0, -1}));
}

TEST(EmbreeScene, RefusesBrokenMeshes) {
    Mesh mesh = rectangle_mesh();
    mesh.triangles[1][2] = 4;
    std::vector<Shape> shapes{shape_of(mesh)};
    EXPECT_THROW(EmbreeScene{shapes}, Error);
    mesh = rectangle_mesh();
    mesh.positions[3][1] = NAN;
    shapes[0] = shape_of(mesh);
    EXPECT_THROW(EmbreeScene{shapes}, Error);
    EXPECT_NO_THROW(EmbreeScene{std::span<const Shape>()});
}

}  // namespace
}  // namespace plumb
