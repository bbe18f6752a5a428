#include "analytic/image_function.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace plumb {
namespace {

using testing::ElementsAre;

std::shared_ptr<const Image> three_by_two() {
    return std::make_shared<Image>(Image{3, 2, {"v"}, {0, 1, 2, 3, 4, 8}});
}

TEST(ImageFunction, NearestTakesThePixelThatHoldsThePoint) {
    const ImageFunction f(three_by_two(), {1}, ImageLookup::nearest);
    EXPECT_EQ(f({0, 0}), 0);
    EXPECT_EQ(f({0.5, 0}), 1);
    EXPECT_EQ(f({0.99, 0.49}), 2);
    EXPECT_EQ(f({0.1, 0.5}), 3);
    EXPECT_EQ(f({1, 1}), 8);
    EXPECT_DOUBLE_EQ(f.integral(), 3);
}

TEST(ImageFunction, BilinearIsLinearBetweenCentresAndConstantBeyond) {
    const ImageFunction f(three_by_two(), {1}, ImageLookup::bilinear);
    EXPECT_EQ(f({0, 0}), 0);
    EXPECT_DOUBLE_EQ(f({0.5, 0.25}), 1);
    EXPECT_DOUBLE_EQ(f({1. / 3, 0.25}), 0.5);
    EXPECT_DOUBLE_EQ(f({0.5, 0.5}), 2.5);
    EXPECT_EQ(f({1, 1}), 8);
    // Piecewise linear on the grid of half pixels: one centre each integrates the bilinear pieces exactly.
    double sum = 0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 6; ++i) sum += f({(i + 0.5) / 6, (j + 0.5) / 4}) / 24;
    EXPECT_NEAR(sum, f.integral(), 1e-14);
}

TEST(ImageFunction, WeighsChannels) {
    const Image image{1, 1, {"R", "G", "B", "A"}, {1, 2, 4, 0.5}};
    EXPECT_THAT(channel_names(image), ElementsAre("R", "G", "B", "A", "luminance"));
    EXPECT_THAT(channel_weights(image, "G"), ElementsAre(0, 1, 0, 0));
    const ImageFunction f(std::make_shared<Image>(image), channel_weights(image, "luminance"), ImageLookup::nearest);
    EXPECT_DOUBLE_EQ(f({0.5, 0.5}), 0.2126 + 2 * 0.7152 + 4 * 0.0722);
    EXPECT_THROW(channel_weights(image, "Z"), Error);
    EXPECT_THAT(channel_names({1, 1, {"Y"}, {1}}), ElementsAre("Y"));
}

}  // namespace
}  // namespace plumb
