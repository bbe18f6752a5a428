// What the claims of verification/suites/lights/lights.cpp do not see: special places, and bad input.

#include <gtest/gtest.h>

#include "core/error.h"
#include "scenes/emitters/constant_environment.h"
#include "scenes/emitters/disk_light.h"
#include "scenes/emitters/environment_map.h"
#include "scenes/emitters/light_chooser.h"
#include "scenes/emitters/mesh_light.h"
#include "scenes/emitters/point_light.h"
#include "scenes/emitters/rectangle_light.h"
#include "scenes/emitters/sphere_light.h"

namespace plumb {
namespace {

const Spectrum white = Spectrum::grey(1);
const RectangleLight ceiling({-1, -1, 2}, {0, 2, 0}, {2, 0, 0}, white);  // shines down

TEST(Lights, ShineToOneSide) {
    EXPECT_TRUE(ceiling.sample({0, 0, 0}, {0.3, 0.4}));
    EXPECT_FALSE(ceiling.sample({0, 0, 3}, {0.3, 0.4}));
    EXPECT_TRUE(ceiling.hit({0, 0, 0}, {0, 0, 1}));
    EXPECT_FALSE(ceiling.hit({0, 0, 3}, {0, 0, -1}));
    EXPECT_FALSE(ceiling.hit({0, 0, 0}, {0, 0, -1}));
    EXPECT_FALSE(ceiling.hit({1.5, 0, 0}, {0, 0, 1}));
    EXPECT_FALSE(SphereLight({}, 1, white).sample({0.5, 0, 0}, {0.3, 0.4}));
    EXPECT_FALSE(SphereLight({}, 1, white, SphereLight::Side::inwards).sample({2, 0, 0}, {0.3, 0.4}));
}

TEST(Lights, LightTheSphereThatTheyAreFromAllOverIt) {
    const SphereLight inwards({0.3, -2, 7}, 1.7, white, SphereLight::Side::inwards);
    for (int i = 0; i < 200; ++i) {  // rounding puts half of these points outside
        const Vec3 p =
            Vec3{0.3, -2, 7} + normalize(Vec3{std::sin(1.0 * i), std::cos(2.0 * i), std::sin(3.0 * i)}) * 1.7;
        EXPECT_TRUE(inwards.sample(p, {0.3, 0.4}));
        EXPECT_DOUBLE_EQ(inwards.hit(p, normalize(Vec3{0.3, -2, 7} - p))->distance, 3.4);
    }
}

TEST(Lights, AreMetWhereTheyStand) {
    EXPECT_DOUBLE_EQ(ceiling.hit({0, 0, 0}, {0, 0, 1})->distance, 2);
    EXPECT_DOUBLE_EQ(SphereLight({0, 0, 5}, 1, white).hit({}, {0, 0, 1})->distance, 4);
    EXPECT_DOUBLE_EQ(SphereLight({0, 0, 0.5}, 1, white, SphereLight::Side::inwards).hit({}, {0, 0, 1})->distance, 1.5);
    EXPECT_DOUBLE_EQ(DiskLight({0, 0, 3}, {0, 0, -1}, 1, white).hit({}, {0, 0, 1})->distance, 3);
    EXPECT_FALSE(DiskLight({0, 0, 3}, {0, 0, -1}, 1, white).hit({1.1, 0, 0}, {0, 0, 1}));
}

TEST(Lights, OfOneMeshHideEachOther) {
    const auto triangle = [](double z) { return Triangle{{-3, -3, z}, {0, 3, z}, {3, -3, z}}; };  // shines down
    const MeshLight mesh({triangle(2), triangle(1)}, white);
    EXPECT_DOUBLE_EQ(mesh.hit({}, {0, 0, 1})->distance, 1);
    EXPECT_DOUBLE_EQ(mesh.hit({}, {0, 0, 1})->pdf, 1 / 36.0);
}

TEST(Lights, OfAPointFallWithTheSquare) {
    const auto sample = PointLight{{0, 0, 2}, white}.sample({}, {0, 0});
    EXPECT_DOUBLE_EQ(sample->radiance[0], 0.25);
    EXPECT_EQ(sample->measure, Measure::discrete);
    EXPECT_FALSE((PointLight{{}, white}.sample({}, {0, 0})));
}

TEST(SphereLight, IsSampledFromFarAndNear) {
    const SphereLight sphere({0, 0, 0}, 1, white);
    // From far the solid angle is π/d².
    EXPECT_NEAR(sphere.sample({0, 0, 1e8}, {0.5, 0.5})->pdf / (1e16 / pi), 1, 1e-12);
    // Next to the surface it is half the sphere.
    EXPECT_NEAR(sphere.sample({0, 0, 1 + 1e-14}, {0.5, 0.5})->pdf * 2 * pi, 1, 1e-6);
}

TEST(EnvironmentMap, IsLookedUpAtPixelCentres) {
    std::vector<Spectrum> pixels;
    for (int i = 0; i < 8; ++i) pixels.push_back(Spectrum::grey(i));
    const EnvironmentMap map(4, 2, pixels);
    EXPECT_DOUBLE_EQ(map.lookup({0.125, 0.25})[0], 0);
    EXPECT_DOUBLE_EQ(map.lookup({0.375, 0.75})[0], 5);
    EXPECT_DOUBLE_EQ(map.lookup({0.25, 0.25})[0], 0.5);
    EXPECT_DOUBLE_EQ(map.lookup({0, 0})[0], 1.5);  // across the left edge, and beyond the top row
    EXPECT_DOUBLE_EQ(map.lookup({1, 0})[0], 1.5);
}

TEST(EnvironmentMap, HasMitsubasAxes) {
    const EnvironmentMap map(4, 2, std::vector<Spectrum>(8, white));
    EXPECT_NEAR(map.place_of({0, 1, 0})[1], 0, 1e-15);
    EXPECT_NEAR(map.place_of({1, 0, 0})[0], 0.25, 1e-15);
    EXPECT_NEAR(map.place_of({0, 0, 1})[0], 0.5, 1e-15);
    EXPECT_NEAR(map.place_of({0, -1, 0})[1], 1, 1e-15);
}

TEST(LightChooser, KeepsProbabilities) {
    const LightChooser chooser = LightChooser::by_power({Spectrum::grey(1), {}, Spectrum::grey(3)});
    EXPECT_DOUBLE_EQ(chooser.pmf(0), 0.25);
    EXPECT_EQ(chooser.pmf(1), 0);
    EXPECT_EQ(chooser.sample(0.2).index, 0u);
    EXPECT_EQ(chooser.sample(0.25).index, 2u);
    EXPECT_EQ(chooser.sample(1 - 0x1p-53).index, 2u);
    EXPECT_DOUBLE_EQ(LightChooser::by_power({{}, {}}).pmf(0), 0.5);
}

TEST(Lights, LetShadowRaysEndBeforeTheTrianglesOfARectangle) {
    for (const Point<2>& u : {Point<2>{0.7, 0.2}, Point<2>{0.2, 0.7}}) {
        const SurfacePoint point = ceiling.sample({}, u)->surface.value();
        EXPECT_NEAR(point.position.x, 2 * u[1] - 1, 1e-15);
        EXPECT_NEAR(point.position.y, 2 * u[0] - 1, 1e-15);
        EXPECT_EQ(point.normal, (Vec3{0, 0, -1}));
        EXPECT_GT(point.margin, 0x1p-21) << "of a disk, which is met in double precision";
    }
}

TEST(Lights, RefuseWhatCannotShine) {
    EXPECT_THROW(RectangleLight({}, {1, 0, 0}, {2, 0, 0}, white), Error);
    EXPECT_THROW(DiskLight({}, {0, 0, 1}, 0, white), Error);
    EXPECT_THROW(SphereLight({}, NAN, white), Error);
    EXPECT_THROW(MeshLight({}, white), Error);
    EXPECT_THROW(MeshLight({{{}, {}, {}}}, white), Error);
    EXPECT_THROW(EnvironmentMap(2, 2, std::vector<Spectrum>(3, white)), Error);
    EXPECT_THROW(EnvironmentMap(1, 1, {Spectrum{}}), Error);
    EXPECT_THROW(EnvironmentMap(1, 1, {Spectrum::grey(-1)}), Error);
    EXPECT_THROW(LightChooser::uniform(0), Error);
}

}  // namespace
}  // namespace plumb
