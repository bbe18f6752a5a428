#include <gmock/gmock.h>

#include "core/error.h"
#include "scenes/film/filters.h"
#include "scenes/sensors/perspective.h"
#include "scenes/sensors/thin_lens.h"

namespace plumb {
namespace {

const CameraPose pose = look_at({1, 2, 3}, {1, 2, 10}, {0, 1, 0});  // looks along z, x to the left

TEST(Perspective, HasItsFieldOfViewAlongTheAxisAsked) {
    const auto half_angle = [](FovAxis axis, Point<2> film) {
        const Ray ray = Perspective(pose, {40, 30}, 90, axis).sample_ray(film, {0, 0});
        return std::acos(ray.direction.z) * 180 / std::numbers::pi;
    };
    EXPECT_NEAR(half_angle(FovAxis::x, {0, 15}), 45, 1e-12);
    EXPECT_NEAR(half_angle(FovAxis::y, {20, 30}), 45, 1e-12);
    EXPECT_NEAR(half_angle(FovAxis::diagonal, {40, 30}), 45, 1e-12);
    EXPECT_NEAR(half_angle(FovAxis::smaller, {20, 0}), 45, 1e-12);
    EXPECT_NEAR(half_angle(FovAxis::larger, {40, 15}), 45, 1e-12);
}

TEST(Perspective, HasXToTheRightAndYDown) {
    const Perspective camera(pose, {40, 30}, 90);
    EXPECT_LT(camera.sample_ray({40, 15}, {0, 0}).direction.x, 0);
    EXPECT_GT(camera.sample_ray({20, 0}, {0, 0}).direction.y, 0);
}

TEST(Sensors, ConnectAlongTheirOwnRays) {
    const Perspective pinhole(pose, {40, 30}, 70);
    const ThinLens lens(pose, {40, 30}, 70, 0.3, 4);
    const Point<2> film{11.25, 7.5}, u{0.2, 0.9};
    const auto expect_own_ray = [&](const auto& sensor) {
        const Ray ray = sensor.sample_ray(film, u);
        const auto back = sensor.connect(ray.origin + ray.direction * 6.0, u);
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->film[0], film[0], 1e-12);
        EXPECT_NEAR(back->film[1], film[1], 1e-12);
        EXPECT_NEAR(back->distance, 6, 1e-14);
        EXPECT_NEAR(dot(back->direction, ray.direction), -1, 1e-14);
        EXPECT_FALSE(sensor.connect(ray.origin - ray.direction * 6.0, u));
        EXPECT_EQ(sensor.pdf({ray.origin, -ray.direction}), 0);
    };
    expect_own_ray(pinhole);
    expect_own_ray(lens);
}

TEST(Sensors, RefuseWhatIsNoCamera) {
    EXPECT_THROW(look_at({1, 1, 1}, {1, 1, 1}, {0, 1, 0}), Error);
    EXPECT_THROW(look_at({}, {0, 2, 0}, {0, 1, 0}), Error);
    EXPECT_THROW(Perspective(pose, {0, 30}, 70), Error);
    EXPECT_THROW(Perspective(pose, {40, 30}, 180), Error);
    EXPECT_THROW(ThinLens(pose, {40, 30}, 70, 0, 4), Error);
    EXPECT_THROW(ThinLens(pose, {40, 30}, 70, 1, NAN), Error);
}

TEST(Filters, EndAtTheirRadius) {
    for (const Filter& filter : {Filter{BoxFilter{}}, Filter{TentFilter{1.5}}, Filter{GaussianFilter{0.5}}})
        std::visit(
            [](const auto& f) {
                EXPECT_NEAR(f.sample(0), -f.radius(), 1e-6);
                EXPECT_NEAR(f.sample(0.5), 0, 1e-12);
                EXPECT_LE(f.sample(1 - 0x1p-53), f.radius());
                EXPECT_EQ(f.pdf(f.radius() * 1.01), 0);
            },
            filter);
    EXPECT_THROW(TentFilter{0}, Error);
    EXPECT_THROW(GaussianFilter{-1}, Error);
}

}  // namespace
}  // namespace plumb
