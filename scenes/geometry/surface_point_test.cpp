#include "scenes/geometry/surface_point.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "scenes/geometry/rounding.h"

namespace plumb {
namespace {

Vec3 random_vector(RandomStream& random) {
    return {2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1};
}

/// Expects coordinates that are floats, by way of memory that the compiler must not think away.
void expect_floats(Vec3 p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        volatile float narrow = static_cast<float>(p[axis]);
        EXPECT_EQ(p[axis], narrow);
    }
}

void expect_floats(const Ray& ray) {
    expect_floats(ray.origin);
    expect_floats(ray.direction);
}

TEST(Rounding, GivesFloats) {
    RandomStream random(1, stream_id("rounding"), 0);
    for (int i = 0; i < 100; ++i) expect_floats(rounded_to_float(random_vector(random)));
}

TEST(SurfacePoint, RaysAreMadeOfFloats) {
    RandomStream random(1, stream_id("rays"), 0);
    for (int i = 0; i < 100; ++i) {
        const std::array<Vec3, 3> corners{random_vector(random), random_vector(random), random_vector(random)};
        const SurfacePoint triangle = triangle_point(Facet(corners), 0.2, 0.3);
        const SurfacePoint sphere = sphere_point({3, 4, 5}, 0.7, normalize(random_vector(random)));
        const SurfacePoint disk = disk_point(random_vector(random), {0, 0, 1}, 1);
        for (const SurfacePoint& from : {triangle, sphere, disk}) expect_floats(leave(from, random_vector(random)));
        expect_floats(connect(triangle, sphere));
        expect_floats(connect(disk, triangle));
        expect_floats(connect_to_space(sphere, random_vector(random)));
        expect_floats(rounded_ray(random_vector(random), random_vector(random)));
    }
}

}  // namespace
}  // namespace plumb
