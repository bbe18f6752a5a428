#include "scenes/film/encoding.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

const Image two_layers{1, 1, {"R", "G", "B", "depth.Z"}, {0.5f, 2.f, 0.f, 7.f}, {{"plumb:seed", "1"}}};

TEST(EncodedFor, KeepsEveryLayerWhereTheFormatHoldsThem) {
    for (const char* file : {"a.exr", "a.tif", "a.tiff"}) {
        const Image image = encoded_for(file, two_layers);
        EXPECT_EQ(image.channels, two_layers.channels) << file;
        EXPECT_EQ(image.values, two_layers.values) << file;
    }
}

TEST(EncodedFor, KeepsLinearColoursWhereTheFormatHoldsFloats) {
    const Image image = encoded_for("a.hdr", two_layers);
    EXPECT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_EQ(image.values, (std::vector<float>{0.5f, 2.f, 0.f}));
    EXPECT_EQ(image.metadata, two_layers.metadata);
}

TEST(EncodedFor, GivesOthersColoursToLookAt) {
    const Image image = encoded_for("a.png", two_layers);
    EXPECT_NEAR(image.values[0], 0.7354, 1e-4);  // 1.055 · 0.5^(1/2.4) − 0.055 [IEC 61966-2-1]
    EXPECT_FLOAT_EQ(image.values[1], 1.f);
    EXPECT_EQ(image.values[2], 0.f);
}

}  // namespace
}  // namespace plumb
