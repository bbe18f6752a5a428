#include "scenes/bsdfs/plastic.h"

#include <gtest/gtest.h>

#include <numbers>

namespace plumb {
namespace {

TEST(Plastic, OfAWhiteBaseLosesNothing) {
    const Plastic bsdf(Spectrum::grey(1), SmoothCoat(1.5), true);
    const Vec3 wo{0.6, 0, 0.8};
    const double mirror = bsdf.discrete(wo);
    double albedo = mirror * bsdf.sample(wo, {mirror / 2, 0.5, 0.5}, Transport::radiance)->weight[0];
    constexpr int n = 100000;
    for (int i = 0; i < n; ++i) {  // the base looks alike from every azimuth: ∫ f cosθ dω = 2π ∫ f cosθ dcosθ
        const double cosine = (i + 0.5) / n, sine = std::sqrt(1 - cosine * cosine);
        albedo += 2 * std::numbers::pi / n * bsdf.eval(wo, {sine, 0, cosine}, Transport::radiance)[0];
    }
    EXPECT_NEAR(albedo, 1, 1e-8);
}

TEST(Plastic, ColoursMoreWhenNonlinear) {
    const Vec3 up{0, 0, 1};
    const Spectrum green = Spectrum::rgb(0.1, 0.8, 0.1);
    const auto ratio = [&](bool nonlinear) {
        const Spectrum f = Plastic(green, SmoothCoat(1.5), nonlinear).eval(up, up, Transport::radiance);
        return f[1] / f[0];
    };
    EXPECT_DOUBLE_EQ(ratio(false), 8);
    EXPECT_GT(ratio(true), 8.5);
}

}  // namespace
}  // namespace plumb
