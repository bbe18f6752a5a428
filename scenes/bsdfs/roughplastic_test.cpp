#include "scenes/bsdfs/roughplastic.h"

#include <gtest/gtest.h>

#include "scenes/bsdfs/fresnel.h"

namespace plumb {
namespace {

TEST(RoughTransmittance, TendsToTheSmoothCoats) {
    const RoughTransmittance coat({MicrofacetShape::ggx, 1e-6}, 1.5);
    for (const double c : {0.05, 0.3, 0.7, 1.0})
        EXPECT_NEAR(coat.at(c), 1 - fresnel_dielectric(c, 1.5).reflectance, 1e-3) << c;
    EXPECT_NEAR(coat.returned(), mean_fresnel_dielectric(1 / 1.5), 1e-3);
}

TEST(RoughPlastic, IsBlackBelow) {
    const RoughTransmittance coat({MicrofacetShape::ggx, 0.1}, 1.5);
    const RoughPlastic bsdf(Spectrum::grey(0.5), coat, true);
    EXPECT_FALSE(bsdf.sample({0, 0, -1}, {0, 0.5, 0.5}, Transport::radiance));
    EXPECT_EQ(bsdf.pdf({0, 0, 1}, {0, 0, -1}), 0);
}

}  // namespace
}  // namespace plumb
