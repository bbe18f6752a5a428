#include "scenes/description/transform.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

void expect_near(Vec3 found, Vec3 expected, double bound = 1e-15) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], bound);
}

TEST(Transform, AppliesTheRightFactorFirst) {
    const Transform both = Transform::translate({1, 2, 3}) * Transform::scale({2, 3, 4});
    expect_near(both.point({1, 1, 1}), {3, 5, 7});
    expect_near(both.vector({1, 1, 1}), {2, 3, 4});
    EXPECT_DOUBLE_EQ(both.determinant(), 24);
}

TEST(Transform, RotatesCounterclockwise) {
    expect_near(Transform::rotate({0, 0, 5}, 90).point({1, 0, 0}), {0, 1, 0});
    expect_near(Transform::rotate({1, 1, 1}, 120).point({1, 0, 0}), {0, 1, 0});
}

TEST(Transform, KeepsNormalsOrthogonalUnderShear) {
    const Transform shear(Transform::Matrix{{{1, 2, 0, 0}, {0, 1, 0, 0}, {0, 0.5, 3, 0}, {0, 0, 0, 1}}});
    const Vec3 along{1, 2, 0}, across{2, -1, 0};
    EXPECT_NEAR(dot(shear.vector(along), shear.normal(across)), 0, 1e-15);
}

TEST(Transform, InverseUndoesIt) {
    const Transform t = Transform::look_at({1, 2, 3}, {-4, 0.5, 9}, {0, 1, 0}) * Transform::scale({1e-3, 20, -7});
    expect_near(t.inverse().point(t.point({0.3, -0.7, 11})), {0.3, -0.7, 11}, 1e-10);
    expect_near((t * t.inverse()).point({1, 2, 3}), {1, 2, 3}, 1e-10);
}

TEST(Transform, LooksAlongZWithUpNearY) {
    const Transform camera = Transform::look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
    expect_near(camera.vector({0, 0, 1}), {0, 0, -1});
    expect_near(camera.vector({0, 1, 0}), {0, 1, 0});
    expect_near(camera.point({0, 0, 0}), {0, 0, 5});
    EXPECT_NEAR(camera.determinant(), 1, 1e-15);
}

TEST(Transform, RefusesWhatHasNoInverse) {
    EXPECT_THROW(Transform::scale({1, 0, 1}), Error);
    EXPECT_THROW(Transform(Transform::Matrix{{{1, 2, 3, 0}, {2, 4, 6, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}), Error);
    EXPECT_THROW(Transform(Transform::Matrix{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 1, 0}}}), Error);
    EXPECT_THROW(Transform::translate({0, std::nan(""), 0}), Error);
    EXPECT_THROW(Transform::look_at({0, 0, 0}, {0, 1, 0}, {0, 2, 0}), Error);
    EXPECT_THROW(Transform::rotate({0, 0, 0}, 10), Error);
    EXPECT_NO_THROW(Transform::scale({1e-9, 1e-9, 1e-9}));
}

}  // namespace
}  // namespace plumb
