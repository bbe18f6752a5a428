#include "scenes/bsdfs/bsdf.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(TwoSided, DoesBelowWhatItDoesAbove) {
    const Bsdf bsdf{Diffuse{Spectrum::grey(0.4)}, true};
    EXPECT_EQ(bsdf.pdf({0, 0, -1}, {0.6, 0, -0.8}), bsdf.pdf({0, 0, 1}, {0.6, 0, 0.8}));
    EXPECT_EQ(bsdf.pdf({0, 0, -1}, {0.6, 0, 0.8}), 0);
    EXPECT_LT(bsdf.sample({0, 0, -1}, {0, 0.5, 0.5}, Transport::radiance)->wi.z, 0);
}

TEST(Albedo, IsTheColourOfASurface) {
    const Spectrum green = Spectrum::rgb(0.1, 0.8, 0.1);
    EXPECT_EQ(albedo({Diffuse{green}}), green);
    EXPECT_EQ(albedo({Plastic(green, SmoothCoat(1.5), false)}), green);
    EXPECT_EQ(albedo({Dielectric{1.5}})[0], 1);
    EXPECT_NEAR(albedo({Conductor{}})[0], 1, 1e-12);  // of index 0: reflects everything
}

TEST(SmoothRoughness, IsThatOfTheNarrowestLobe) {
    const RoughTransmittance coat({MicrofacetShape::ggx, 0.3}, 1.5);
    EXPECT_EQ(smooth_roughness({Diffuse{}}), 1);
    EXPECT_EQ(smooth_roughness({Plastic(Spectrum::grey(0.5), SmoothCoat(1.5), false)}), 1);
    EXPECT_EQ(smooth_roughness({RoughPlastic(Spectrum::grey(0.5), coat, false)}), 0.3);
    EXPECT_EQ(smooth_roughness({RoughConductor{{MicrofacetShape::beckmann, 0.2}, {}}}), 0.2);
    EXPECT_EQ(smooth_roughness({Dielectric{1.5}}), 0);
}

TEST(EtaBetween, IsThatOfASample) {
    const Bsdf glass{RoughDielectric{{MicrofacetShape::ggx, 0.4}, 1.5}};
    for (const Vec3 wo : {Vec3{0.6, 0, 0.8}, Vec3{0.28, 0, -0.96}})
        for (int i = 0; i < 100; ++i)
            if (const auto sample = glass.sample(wo, {i / 100.0, 0.3, 0.7}, Transport::radiance)) {
                EXPECT_EQ(eta_between(glass, wo, sample->wi), sample->eta);
            }
    EXPECT_EQ(eta_between({Diffuse{}}, {0, 0, 1}, {0, 0, 1}), 1);
}

}  // namespace
}  // namespace plumb
