#include "scenes/bsdfs/conductor.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Conductor, MirrorsEverythingWithoutARealIndex) {
    const Conductor bsdf{Spectrum::grey(0), Spectrum::grey(1)};
    const auto sample = bsdf.sample({0.6, 0, 0.8}, {0.9, 0, 0}, Transport::radiance);
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->wi, (Vec3{-0.6, 0, 0.8}));
    EXPECT_EQ(sample->measure, Measure::discrete);
    EXPECT_DOUBLE_EQ(sample->weight[1], 1);
}

TEST(Conductor, IsBlackBelow) {
    EXPECT_FALSE(Conductor{}.sample({0, 0, -1}, {0, 0, 0}, Transport::radiance));
    EXPECT_EQ(Conductor{}.discrete({0, 0, -1}), 0);
}

}  // namespace
}  // namespace plumb
