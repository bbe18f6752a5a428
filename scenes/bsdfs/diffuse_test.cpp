#include "scenes/bsdfs/diffuse.h"

#include <gtest/gtest.h>

#include <numbers>

namespace plumb {
namespace {

TEST(Diffuse, IsAlbedoOverPiTimesTheCosine) {
    const Diffuse bsdf{Spectrum::grey(0.3)};
    EXPECT_DOUBLE_EQ(bsdf.eval({0, 0, 1}, {0.6, 0, 0.8}, Transport::radiance)[0], 0.3 * 0.8 / std::numbers::pi);
    EXPECT_EQ(bsdf.sample({0, 0, 1}, {0, 0.25, 0.5}, Transport::radiance)->weight, bsdf.reflectance);
}

TEST(Diffuse, IsBlackBelow) {
    const Diffuse bsdf;
    EXPECT_TRUE(is_black(bsdf.eval({0, 0, -1}, {0, 0, -1}, Transport::radiance)));
    EXPECT_EQ(bsdf.pdf({0, 0, 1}, {0, 0, -1}), 0);
    EXPECT_FALSE(bsdf.sample({0, 0, -1}, {0, 0.5, 0.5}, Transport::radiance));
}

}  // namespace
}  // namespace plumb
