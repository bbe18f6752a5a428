#include "estimators/densities/warps.h"

#include <gmock/gmock.h>

namespace plumb {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

const std::vector<Point<2>> places{{0.1, 0.7}, {0.5, 0.2}, {0.93, 0.41}, {0.25, 0.25}, {0.999, 0.001}};

auto near(const Point<2>& u) {
    return ElementsAre(DoubleNear(u[0], 1e-12), DoubleNear(u[1], 1e-12));
}

TEST(Warps, AreUndoneByTheirInverse) {
    for (const Point<2>& u : places) {
        EXPECT_THAT(invert_polar_disk(sample_polar_disk(u)), near(u));
        EXPECT_THAT(invert_concentric_disk(sample_concentric_disk(u)), near(u));
        EXPECT_THAT(invert_cosine_hemisphere(sample_cosine_hemisphere(u)), near(u));
        EXPECT_THAT(invert_uniform_sphere(sample_uniform_sphere(u)), near(u));
        EXPECT_THAT(invert_uniform_cone(sample_uniform_cone(u, 1e-9), 1e-9), near(u));
        EXPECT_THAT(invert_uniform_triangle(sample_uniform_triangle(u)), near(u));
    }
}

TEST(Warps, GiveUnitDirections) {
    for (const Point<2>& u : places) {
        EXPECT_NEAR(length(sample_cosine_hemisphere(u)), 1, 1e-15);
        EXPECT_NEAR(length(sample_uniform_sphere(u)), 1, 1e-15);
        EXPECT_NEAR(length(sample_uniform_cone(u, 0.3)), 1, 1e-15);
    }
}

TEST(Warps, HaveNoDensityOutside) {
    EXPECT_EQ(polar_disk_pdf({0.8, 0.7}), 0);
    EXPECT_EQ(cosine_hemisphere_pdf({0, 0, -1}), 0);
    EXPECT_EQ(uniform_triangle_pdf({0.6, 0.6}), 0);
    EXPECT_EQ(uniform_cone_pdf({1, 0, 0}, 0.5), 0);
    EXPECT_GT(uniform_cone_pdf({0, 0, 1}, 0.5), 0);
}

TEST(Warps, MapTheCentreOfTheSquareToTheCentreOfTheDisk) {
    EXPECT_THAT(sample_concentric_disk({0.5, 0.5}), ElementsAre(0, 0));
}

}  // namespace
}  // namespace plumb
