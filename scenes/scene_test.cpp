#include "scenes/scene.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "estimators/densities/warps.h"
#include "scenes/emitters/sphere_light.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"

namespace plumb {
namespace {

// A ray starts a rounding error beside its vertex. Seen from the vertex itself, some rays that meet a light at its rim
// miss it; a density of 0 would give them the whole weight.
TEST(Scene, KnowsADensityForEveryLightThatARayMeets) {
    const Scene scene(load_mitsuba(scene_file("sphere_light"), {}));
    RayLog log;
    const Vec3 point{0.3, 0, -0.985}, to_centre = Vec3{0, 1, 0} - point;
    const Hit floor = scene.intersect(rounded_ray(point + Vec3{0, 1, -1}, {0, -1, 1}), 0.5, log).value();
    const Frame frame(normalize(to_centre));
    const double rim = std::asin(0.5 / length(to_centre));
    const SphereLight light({0, 1, 0}, 0.5, Spectrum::grey(4));
    int met = 0, met_only_from_its_start = 0;
    for (int i = 0; i < 40'000; ++i) {
        const double turn = 2 * pi * i / 40'000, off_axis = rim + 1e-8 * (i % 199 - 99);
        const Vec3 direction = frame.to_world(
            {std::sin(off_axis) * std::cos(turn), std::sin(off_axis) * std::sin(turn), std::cos(off_axis)});
        const auto hit = scene.intersect(leave(floor.point, direction), 0.5, log);
        if (!hit || is_black(scene.emitted(*hit, -direction))) continue;
        ++met;
        met_only_from_its_start += light.hit(floor.point.position, direction) ? 0 : 1;
        ASSERT_DOUBLE_EQ(scene.light_pdf(*hit, floor.point.position, direction), light.pdf(floor.point.position))
            << "ray " << i;
    }
    EXPECT_GT(met, 10'000);
    EXPECT_GT(met_only_from_its_start, 1000);
}

TEST(Scene, MustBeOfASizeThatRaysInFloatsCanTell) {
    const auto ball = [](Vec3 center, double radius) {
        description::Scene scene;
        scene.materials.push_back({description::Diffuse{Spectrum::grey(1)}, {}, {}});
        scene.shapes.push_back(
            {.geometry = description::Sphere{.center = center, .radius = radius, .flip_normals = false, .to_world = {}},
             .material = {},
             .emitter = {},
             .id = {},
             .place = {}});
        return scene;
    };
    EXPECT_NO_THROW(Scene(ball({}, 0x1p-35)));
    EXPECT_NO_THROW(Scene(ball({0x1p38, 0, 0}, 0x1p38)));
    EXPECT_THROW(Scene(ball({}, 0x1p-40)), Error);
    EXPECT_THROW(Scene(ball({0x1p41, 0, 0}, 1)), Error);
}

}  // namespace
}  // namespace plumb
