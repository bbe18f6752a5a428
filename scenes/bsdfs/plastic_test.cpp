#include "scenes/bsdfs/plastic.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Plastic, OfAWhiteBaseLosesNothing) {
    const Plastic bsdf(Spectrum::grey(1), 1.5, true);
    const Vec3 wo{0.6, 0, 0.8};
    constexpr int n = 100000;
    double albedo = 0;
    for (int i = 0; i < n; ++i)
        albedo += bsdf.sample(wo, {(i + 0.5) / n, (i * 0.618034) - std::floor(i * 0.618034), 0.5}, Transport::radiance)
                      ->weight[0] /
                  n;
    EXPECT_NEAR(albedo, 1, 1e-4);
}

TEST(Plastic, ColoursMoreWhenNonlinear) {
    const Vec3 up{0, 0, 1};
    const Spectrum green = Spectrum::rgb(0.1, 0.8, 0.1);
    const auto ratio = [&](bool nonlinear) {
        const Spectrum f = Plastic(green, 1.5, nonlinear).eval(up, up, Transport::radiance);
        return f[1] / f[0];
    };
    EXPECT_DOUBLE_EQ(ratio(false), 8);
    EXPECT_GT(ratio(true), 8.5);
}

}  // namespace
}  // namespace plumb
