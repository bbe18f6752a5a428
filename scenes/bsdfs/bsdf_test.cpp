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

}  // namespace
}  // namespace plumb
