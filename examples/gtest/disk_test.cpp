#include "disk.h"
#include "verification/evidence/distribution.h"
#include "verification/evidence/mean.h"
#include "verification/gtest.h"

Polar draw(plumb::RandomStream& random) {
    const double u = random.uniform(), v = random.uniform();
    return sample_disk(u, v);
}

TEST(Disk, IsUniform) {  // four rings of equal area by four sectors
    const auto cell = [](plumb::RandomStream& random) {
        const Polar p = draw(random);
        return 4 * plumb::equal_cell(p.radius * p.radius, 4) + plumb::equal_cell(p.angle / 2 / std::numbers::pi, 4);
    };
    const plumb::DistributionClaim uniform{.probabilities = std::vector(16, 1 / 16.0), .delta = 0.05};
    EXPECT_TRUE(plumb::holds(plumb::distribution_is(cell, uniform, plumb::trial())));
}

TEST(Disk, HasMeanRadiusTwoThirds) {
    const auto radius = [](plumb::RandomStream& random) { return draw(random).radius; };
    EXPECT_TRUE(
        plumb::holds(plumb::mean_is(radius, {.reference = 2 / 3.0, .delta = 2e-3, .bounds = {0, 1}}, plumb::trial())));
}
