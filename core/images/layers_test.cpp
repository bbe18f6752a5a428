#include "core/images/layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

Image image_of(std::vector<std::string> channels) {
    Image image{1, 1, std::move(channels), {}};
    for (std::size_t c = 0; c < image.channels.size(); ++c) image.values.push_back(static_cast<float>(c));
    return image;
}

std::string complaint(const Image& image, const std::string& layer = "") {
    try {
        picture_layer(image, "a.exr", layer);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ImageLayers, FindColoursByTheirNames) {
    EXPECT_THAT(colours_of(image_of({"A", "B", "G", "R"})), ElementsAre("R", "G", "B"));
    EXPECT_THAT(colours_of(image_of({"X", "Y", "Z"})), ElementsAre("X", "Y", "Z"));
    EXPECT_THAT(colours_of(image_of({"depth", "Y"})), ElementsAre("Y"));
    EXPECT_THAT(colours_of(image_of({"C", "M", "Y", "K"})), ElementsAre());
}

TEST(ImageLayers, AreChosenByNameOrByBeingTheOnlyOne) {
    const Image plain = image_of({"R", "G", "B", "albedo.R", "albedo.G", "albedo.B"});
    EXPECT_EQ(picture_layer(plain, "a.exr").channels, plain.channels);
    const Image albedo = picture_layer(plain, "a.exr", "albedo");
    EXPECT_THAT(albedo.channels, ElementsAre("R", "G", "B"));
    EXPECT_THAT(albedo.values, ElementsAre(3, 4, 5));
    const Image only = picture_layer(image_of({"view.depth.Z", "view.all.B", "view.all.G", "view.all.R"}), "a.exr");
    EXPECT_THAT(only.channels, ElementsAre("B", "G", "R"));
}

TEST(ImageLayers, AreNamedWhereNoneOrSeveralWillDo) {
    const Image two = image_of({"a.R", "a.G", "a.B", "b.Y"});
    EXPECT_THAT(complaint(two),
                AllOf(HasSubstr("a.exr: has colours in several layers"), HasSubstr("of one layer: a, b")));
    EXPECT_THAT(complaint(two, "c"), HasSubstr("has no colours in a layer 'c'"));
    EXPECT_THAT(complaint(image_of({"C", "M", "Y", "K"})), HasSubstr("has no colours; its channels are C, M, Y, K"));
}

}  // namespace
}  // namespace plumb
