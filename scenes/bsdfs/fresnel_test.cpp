#include "scenes/bsdfs/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace {

TEST(Fresnel, IsTheSquareOfTheContrastAtNormalIncidence) {
    EXPECT_DOUBLE_EQ(fresnel_dielectric(1, 1.5).reflectance, 0.04);
    EXPECT_DOUBLE_EQ(fresnel_dielectric(1, 1 / 1.5).reflectance, 0.04);
    EXPECT_DOUBLE_EQ(fresnel_conductor(1, 0.2, 3), (0.64 + 9) / (1.44 + 9));
}

TEST(Fresnel, KnowsItsCorners) {
    EXPECT_DOUBLE_EQ(fresnel_dielectric(0, 1.5).reflectance, 1);
    EXPECT_EQ(fresnel_dielectric(0.3, 1).reflectance, 0);
    EXPECT_EQ(fresnel_dielectric(0.3, 1).cos_t, 0.3);
    EXPECT_EQ(fresnel_dielectric(0.6, 1 / 1.5).reflectance, 1);  // the critical cosine is 0.745
    EXPECT_DOUBLE_EQ(fresnel_conductor(0, 0.2, 3), 1);
    EXPECT_NEAR(fresnel_conductor(0.5, 1, 0), 0, 1e-32);
}

TEST(Fresnel, OfAConductorWithoutAbsorptionIsTheDielectrics) {
    for (const double c : {0.05, 0.3, 0.9})
        EXPECT_NEAR(fresnel_conductor(c, 1.5, 0), fresnel_dielectric(c, 1.5).reflectance, 1e-15);
}

TEST(Fresnel, MeanIsTheIntegral) {
    for (const double eta : {1.1, 1.5, 2.4, 1 / 1.5}) {
        constexpr int n = 200000;
        double mean = 0;
        for (int i = 0; i < n; ++i) {
            const double c = (i + 0.5) / n;
            mean += 2 * c * fresnel_dielectric(c, eta).reflectance / n;
        }
        EXPECT_NEAR(mean_fresnel_dielectric(eta), mean, 1e-7) << eta;
    }
}

}  // namespace
}  // namespace plumb
