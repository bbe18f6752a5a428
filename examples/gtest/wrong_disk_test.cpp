// The mistake that everybody makes once: points crowd at the centre because the radius lacks its square root. Both
// tests fail, and say what was found.

#include "verification/evidence/distribution.h"
#include "verification/evidence/mean.h"
#include "verification/gtest.h"

double radius(plumb::RandomStream& random) {
    return random.uniform();
}

TEST(WrongDisk, IsUniform) {  // sixteen rings of equal area
    const auto ring = [](plumb::RandomStream& random) {
        const double r = radius(random);
        return plumb::equal_cell(r * r, 16);
    };
    const plumb::DistributionClaim uniform{.probabilities = std::vector(16, 1 / 16.0), .delta = 0.05};
    EXPECT_TRUE(plumb::holds(plumb::distribution_is(ring, uniform, plumb::trial())));
}

TEST(WrongDisk, HasMeanRadiusTwoThirds) {
    EXPECT_TRUE(
        plumb::holds(plumb::mean_is(radius, {.reference = 2 / 3.0, .delta = 2e-3, .bounds = {0, 1}}, plumb::trial())));
}
