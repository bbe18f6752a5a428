#include "scenes/bsdfs/thindielectric.h"

#include <gtest/gtest.h>

#include "scenes/bsdfs/fresnel.h"

namespace plumb {
namespace {

TEST(ThinDielectric, MirrorsOrLetsThroughUnturned) {
    const ThinDielectric pane{1.5};
    for (const Vec3 wo : {Vec3{0.6, 0, 0.8}, Vec3{0, 0.6, -0.8}}) {
        const auto mirrored = pane.sample(wo, {0, 0.5, 0.5}, Transport::radiance);
        const auto through = pane.sample(wo, {0.999, 0.5, 0.5}, Transport::radiance);
        ASSERT_TRUE(mirrored && through);
        EXPECT_EQ(mirrored->wi, (Vec3{-wo.x, -wo.y, wo.z}));
        EXPECT_EQ(through->wi, -wo);
        EXPECT_DOUBLE_EQ(mirrored->pdf + through->pdf, 1);
        EXPECT_EQ(through->weight, Spectrum::grey(1));
        EXPECT_EQ(through->eta, 1);
        EXPECT_EQ(pane.sample(wo, {0.999, 0.5, 0.5}, Transport::importance)->weight, Spectrum::grey(1));
    }
    EXPECT_FALSE(pane.sample({1, 0, 0}, {0, 0, 0}, Transport::radiance));
}

TEST(ThinDielectric, ReflectsAsTwoInterfacesDo) {
    for (const double cosine : {1e-6, 0.1, 0.5, 0.8, 1.0})
        for (const double eta : {1.5, 1 / 1.5, 1.0}) {
            const double once = fresnel_dielectric(cosine, eta).reflectance;
            double sum = once, within = (1 - once) * (1 - once) * once;
            for (int i = 0; i < 1'000'000 && within > 0; ++i, within *= once * once) sum += within;
            EXPECT_NEAR(pane_reflectance(cosine, eta), sum, 1e-6) << cosine << ' ' << eta;
        }
    EXPECT_EQ(pane_reflectance(0.1, 1 / 1.5), 1);  // beyond the critical angle
}

}  // namespace
}  // namespace plumb
