#include "scenes/bsdfs/dielectric.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Dielectric, ReflectsByFresnelAndRefractsBySnell) {
    const Dielectric glass{1.5};
    const Vec3 wo{0.6, 0, 0.8};
    const auto reflected = glass.sample(wo, {0, 0.5, 0.5}, Transport::radiance);
    const auto refracted = glass.sample(wo, {0.999, 0.5, 0.5}, Transport::radiance);
    ASSERT_TRUE(reflected && refracted);
    EXPECT_EQ(reflected->wi, (Vec3{-0.6, 0, 0.8}));
    EXPECT_DOUBLE_EQ(refracted->wi.x, -0.4);  // sine 0.6/1.5
    EXPECT_LT(refracted->wi.z, 0);
    EXPECT_NEAR(length(refracted->wi), 1, 1e-15);
    EXPECT_DOUBLE_EQ(reflected->pdf + refracted->pdf, 1);
    EXPECT_DOUBLE_EQ(refracted->weight[0], 1 / 2.25);
    EXPECT_EQ(glass.sample(wo, {0.999, 0.5, 0.5}, Transport::importance)->weight[0], 1);
}

TEST(Dielectric, ReflectsAllBeyondTheCriticalAngle) {
    const auto sample = Dielectric{1.5}.sample({0.8, 0, -0.6}, {0.999999, 0, 0}, Transport::radiance);
    ASSERT_TRUE(sample);
    EXPECT_LT(sample->wi.z, 0);
    EXPECT_EQ(sample->pdf, 1);
}

TEST(Dielectric, IsNothingWithoutContrast) {
    const auto sample = Dielectric{1}.sample({0.6, 0, 0.8}, {0, 0, 0}, Transport::radiance);
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->wi, (Vec3{-0.6, 0, -0.8}));
}

}  // namespace
}  // namespace plumb
