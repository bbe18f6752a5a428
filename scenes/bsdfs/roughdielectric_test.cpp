#include "scenes/bsdfs/roughdielectric.h"

#include <gtest/gtest.h>

#include "scenes/bsdfs/dielectric.h"

namespace plumb {
namespace {

TEST(RoughDielectric, TendsToTheSmoothOne) {
    const RoughDielectric rough{{MicrofacetShape::ggx, 1e-6}, 1.5};
    const Dielectric smooth{1.5};
    for (const Vec3 wo : {Vec3{0.6, 0, 0.8}, {0.3, 0.4, -std::sqrt(0.75)}, {0.8, 0, -0.6}})
        for (const double u : {0.001, 0.999}) {
            const auto a = rough.sample(wo, {u, 0.3, 0.6}, Transport::radiance);
            const auto b = smooth.sample(wo, {u, 0.3, 0.6}, Transport::radiance);
            ASSERT_TRUE(a && b);
            EXPECT_LT(length(a->wi - b->wi), 1e-4);
            EXPECT_EQ(a->eta, b->eta);
            EXPECT_NEAR(a->weight[0], b->weight[0], 1e-4);
        }
}

}  // namespace
}  // namespace plumb
