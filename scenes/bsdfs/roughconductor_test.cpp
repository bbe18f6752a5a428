#include "scenes/bsdfs/roughconductor.h"

#include <gtest/gtest.h>

#include <numbers>

namespace plumb {
namespace {

TEST(RoughConductor, AtTheNormalIsTheDistributionOverFour) {
    const RoughConductor bsdf{{MicrofacetShape::ggx, 0.2}, Spectrum::grey(0), Spectrum::grey(1)};
    EXPECT_DOUBLE_EQ(bsdf.eval({0, 0, 1}, {0, 0, 1}, Transport::radiance)[0], 1 / (4 * std::numbers::pi * 0.04));
    EXPECT_DOUBLE_EQ(bsdf.pdf({0, 0, 1}, {0, 0, 1}), 1 / (4 * std::numbers::pi * 0.04));
}

TEST(RoughConductor, IsBlackBelow) {
    EXPECT_FALSE(RoughConductor{}.sample({0, 0, -1}, {0, 0.5, 0.5}, Transport::radiance));
    EXPECT_EQ(RoughConductor{}.pdf({0, 0, 1}, {0, 0, -1}), 0);
}

}  // namespace
}  // namespace plumb
