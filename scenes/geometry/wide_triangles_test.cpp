#include "scenes/geometry/wide_triangles.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "scenes/geometry/embree_scene.h"

namespace plumb {
namespace {

using description::Shape;
using description::Sphere;

Shape shape_of(auto geometry) {
    return {.geometry = std::move(geometry), .material = {}, .emitter = {}, .id = {}, .place = {}};
}

Mesh square(double half_side, double height = 0) {
    return transformed(rectangle_mesh(),
                       Transform::translate({0, 0, height}) * Transform::scale({half_side, half_side, 1}));
}

TEST(WideTriangles, AreThoseThatDwarfTheSmallestThing) {
    std::array<Shape, 3> shapes{
        shape_of(square(1e4)), shape_of(square(10)),
        shape_of(Sphere{.center = {0, 0, 1}, .radius = 0.5, .flip_normals = false, .to_world = {}})};
    meet_wide_triangles_in_doubles(shapes);
    EXPECT_EQ(wide_triangles(std::get<Mesh>(shapes[0].geometry)), (std::vector<std::uint32_t>{0, 1}));
    EXPECT_TRUE(wide_triangles(std::get<Mesh>(shapes[1].geometry)).empty());
}

TEST(WideTriangles, OfOneMeshKeepTheirNumbersBesideSmallOnes) {
    Mesh mesh = square(1e5);
    const Mesh small = square(1, 2);
    mesh.positions.insert(mesh.positions.end(), small.positions.begin(), small.positions.end());
    for (const auto& [i, j, k] : small.triangles) mesh.triangles.push_back({i + 4, j + 4, k + 4});
    mesh.normals.clear();
    mesh.uvs.clear();
    std::array<Shape, 1> shapes{shape_of(mesh)};
    meet_wide_triangles_in_doubles(shapes);
    EXPECT_EQ(wide_triangles(std::get<Mesh>(shapes[0].geometry)), (std::vector<std::uint32_t>{0, 1}));

    const EmbreeScene scene(shapes);
    const Hit above = scene.intersect(rounded_ray({0.5, 0.25, 5}, {0, 0, -1})).value();
    EXPECT_GE(above.primitive, 2u);
    EXPECT_FLOAT_EQ(static_cast<float>(above.t), 3);
    const Hit below = scene.intersect(rounded_ray({0.5, 0.25, 1}, {0, 0, -1})).value();
    EXPECT_LT(below.primitive, 2u);
    EXPECT_EQ(below.shape, 0u);
    EXPECT_NEAR(below.point.position.x, 0.5, 1e-9);
    EXPECT_NEAR(below.point.position.y, 0.25, 1e-9);
    EXPECT_TRUE(scene.occluded(leave(below.point, {0, 0, 1})));
}

TEST(WideTriangles, LetNoRayPassBetweenThem) {
    const Mesh mesh = square(1e8);
    RandomStream random(1);
    for (int i = 0; i < 10'000; ++i) {  // at the diagonal, which the triangles have in common
        const double s = 1e8 * (2 * random.uniform() - 1);
        const Ray ray = rounded_ray({3, -5, 1}, {s - 3, s + 5, -1});
        EXPECT_TRUE(meet_triangle(mesh.corners(0), ray) || meet_triangle(mesh.corners(1), ray)) << s;
    }
}

TEST(MeetTriangle, GivesTheDistanceAndTheCoordinatesOfThePlace) {
    const std::array<Vec3, 3> corners{{{0, 0, 0}, {4, 0, 0}, {0, 8, 0}}};
    const TriangleHit hit = meet_triangle(corners, {{1, 2, 3}, {0, 0, -2}, 10}).value();
    EXPECT_DOUBLE_EQ(hit.t, 1.5);
    EXPECT_DOUBLE_EQ(hit.u, 0.25);
    EXPECT_DOUBLE_EQ(hit.v, 0.25);
    EXPECT_FALSE(meet_triangle(corners, {{1, 2, 3}, {0, 0, -2}, 1}));   // too far
    EXPECT_FALSE(meet_triangle(corners, {{1, 2, 3}, {0, 0, 2}, 10}));   // behind
    EXPECT_FALSE(meet_triangle(corners, {{4, 8, 3}, {0, 0, -2}, 10}));  // beside
    EXPECT_FALSE(meet_triangle(corners, {{-1, 1, 0}, {1, 0, 0}, 10}));  // within its plane
    EXPECT_TRUE(meet_triangle(corners, {{1, 2, -3}, {0, 0, 2}, 10}));   // from the other side
}

}  // namespace
}  // namespace plumb
