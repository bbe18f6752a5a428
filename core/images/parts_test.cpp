#include "core/images/parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ImagePart part_of(int width, int height, std::vector<std::string> channels, std::vector<float> values) {
    const PixelWindow window{0, 0, width, height};
    return {{width, height, std::move(channels), std::move(values)}, window, window};
}

Image read(ImagePart part, std::string format = "openexr") {
    return picture_of(ImageParts{std::move(format), {std::move(part)}});
}

TEST(ImageParts, ShowTheDisplayWindow) {
    ImagePart part = part_of(2, 2, {"Y"}, {1, 2, 3, 4});
    part.data = {1, -1, 2, 2};  // its lower row is in sight, a column to the right
    part.display = {0, 0, 3, 2};
    const Image image = read(part);
    EXPECT_EQ(image.width, 3);
    EXPECT_THAT(image.values, ElementsAre(0, 3, 4, 0, 0, 0));
}

// What is stored as abc/def, seen upright.
TEST(ImageParts, StandUpright) {
    const std::vector<std::vector<float>> seen{{1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}, {6, 5, 4, 3, 2, 1},
                                               {4, 5, 6, 1, 2, 3}, {1, 4, 2, 5, 3, 6}, {4, 1, 5, 2, 6, 3},
                                               {6, 3, 5, 2, 4, 1}, {3, 6, 2, 5, 1, 4}};
    for (int orientation = 1; orientation <= 8; ++orientation) {
        ImagePart part = part_of(3, 2, {"Y"}, {1, 2, 3, 4, 5, 6});
        part.orientation = orientation;
        const Image image = read(part, "tiff");
        EXPECT_EQ(image.width, orientation >= 5 ? 2 : 3);
        EXPECT_EQ(image.values, seen[static_cast<std::size_t>(orientation - 1)]) << orientation;
    }
}

TEST(ImageParts, HaveTheUsualNamesForChannels) {
    EXPECT_THAT(read(part_of(1, 1, {"red", "Green", "b", "ALPHA"}, {1, 2, 3, 4})).channels,
                ElementsAre("R", "G", "B", "A"));
    EXPECT_THAT(read(part_of(1, 1, {"view.r", "depth"}, {1, 2})).channels, ElementsAre("view.R", "depth"));
    EXPECT_THAT(read(part_of(1, 1, {"R", "r"}, {1, 2})).channels, ElementsAre("R", "r"));
}

TEST(ImageParts, OfLuminanceAndChromaAreRgb) {
    const double r = 0.5, g = 0.25, b = 0.75, y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    const Image image =
        read(part_of(1, 1, {"Y", "BY", "RY"},
                     {static_cast<float>(y), static_cast<float>((b - y) / y), static_cast<float>((r - y) / y)}));
    EXPECT_THAT(image.channels, ElementsAre("G", "B", "R"));
    EXPECT_NEAR(image.values[0], g, 1e-6);
    EXPECT_NEAR(image.values[1], b, 1e-6);
    EXPECT_NEAR(image.values[2], r, 1e-6);
}

TEST(ImageParts, AreLayersOfOneImage) {
    ImagePart a = part_of(2, 1, {"R", "G"}, {1, 2, 3, 4}), b = part_of(2, 1, {"b.Y"}, {5, 6});
    a.name = "a";
    b.name = "b";
    const Image image = picture_of(ImageParts{"openexr", {a, b}});
    EXPECT_THAT(image.channels, ElementsAre("a.R", "a.G", "b.Y"));
    EXPECT_THAT(image.values, ElementsAre(1, 2, 5, 3, 4, 6));
    b.image = {1, 1, {"b.Y"}, {5}};
    b.data = b.display = {0, 0, 1, 1};
    try {
        picture_of(ImageParts{"openexr", {a, b}});
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), HasSubstr("'a' and 'b' have 2 × 1 and 1 × 1 pixels"));
    }
}

TEST(ImageParts, OfWebpMustNotHaveLostTheirColours) {
    EXPECT_NO_THROW(read(part_of(1, 1, {"R", "G", "B", "A"}, {1, 1, 1, 1}), "webp"));
    EXPECT_THROW(read(part_of(1, 1, {"R", "G", "B", "A"}, {0, 0, 0, 0.5f}), "webp"), std::invalid_argument);
}

}  // namespace
}  // namespace plumb
