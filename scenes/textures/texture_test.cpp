#include "scenes/textures/texture.h"

#include "core/images/image.h"
#include "core/srgb.h"
#include "scenes/test_files.h"

namespace plumb {
namespace {

using Textures = testing_files::Folder;
using description::Wrap;

const Texels four{2, 2, {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4}};

TEST(Texture, IsItsTexelsAtTheirCentres) {
    EXPECT_DOUBLE_EQ(bilinear(four, Wrap::repeat, 0.25, 0.25)[0], 1);
    EXPECT_DOUBLE_EQ(bilinear(four, Wrap::repeat, 0.75, 0.25)[0], 2);
    EXPECT_DOUBLE_EQ(bilinear(four, Wrap::repeat, 0.25, 0.75)[0], 3);  // v grows downwards
    EXPECT_DOUBLE_EQ(bilinear(four, Wrap::repeat, 0.5, 0.5)[2], 2.5);
    EXPECT_DOUBLE_EQ(bilinear(four, Wrap::repeat, 17.75, -4.25)[0], 4);
    EXPECT_DOUBLE_EQ(bilinear(four, Wrap::repeat, 0, 0.25)[0], 1.5);  // half way to the last column
    EXPECT_DOUBLE_EQ(bilinear(four, Wrap::clamp, -3, 0.25)[0], 1);
    EXPECT_DOUBLE_EQ(bilinear(four, Wrap::mirror, -0.75, 0.25)[0], 2);
    EXPECT_DOUBLE_EQ(bilinear(four, Wrap::mirror, 0, 0.25)[0], 1);
    EXPECT_TRUE(is_finite(bilinear(four, Wrap::repeat, 1e300, -1e300)));
}

TEST(Texture, CheckerboardHasSquaresOfSideOneHalf) {
    const description::Texture texture{.kind = description::Checkerboard{Spectrum::grey(1), Spectrum::grey(0)},
                                       .to_uv = Transform::scale({2, 1, 1}),
                                       .place = {}};
    const TextureLookup board(texture);
    EXPECT_EQ(board.at(0.1, 0.1)[0], 1);
    EXPECT_EQ(board.at(0.3, 0.1)[0], 0);
    EXPECT_EQ(board.at(0.3, 0.6)[0], 1);
    EXPECT_EQ(board.at(-0.1, 0.1)[0], 0);
}

TEST_F(Textures, IntegersAreSrgbUnlessRaw) {
    const auto file = write("a.ppm", std::string("P6\n2 1\n255\n\xff\x80\x00\xff\xff\xff", 17));
    const Texels image = read_texels(file), raw = read_texels(file, true);
    ASSERT_EQ(image.width, 2);
    EXPECT_NEAR(raw.texel(0, 0)[1], 128 / 255.0, 1e-6);
    EXPECT_NEAR(image.texel(0, 0)[1], std::pow((128 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_FLOAT_EQ(static_cast<float>(image.texel(1, 0)[2]), 1);
}

TEST_F(Textures, AreDecodedAsTheFileSays) {
    const float stored = 128 / 255.f;
    const auto texel = [&](const char* name, std::vector<std::string> channels, std::vector<float> values,
                           std::map<std::string, std::string> says = {}) {
        write_image(path_ / name, {1, 1, std::move(channels), std::move(values), std::move(says)});
        return read_texels(path_ / name).texel(0, 0);
    };
    const double decoded = linear_from_srgb(static_cast<double>(stored));
    EXPECT_NEAR(texel("a.png", {"R", "G", "B"}, {1, stored, 0})[1], decoded, 1e-6);
    EXPECT_NEAR(texel("b.png", {"R", "G", "B"}, {1, stored, 0}, {{"oiio:ColorSpace", "Linear"}})[1], stored, 1e-6);
    EXPECT_NEAR(texel("c.exr", {"R", "G", "B"}, {1, stored, 0})[1], stored, 1e-6);
    EXPECT_NEAR(texel("d.exr", {"Y"}, {stored})[2], stored, 1e-6);
    EXPECT_NEAR(texel("e.exr", {"depth.Z", "view.R", "view.G", "view.B"}, {9, 1, stored, 0})[1], stored, 1e-6);
    EXPECT_EQ(
        message([&] {
            texel("f.dpx", {"R", "G", "B"}, {1, 1, 1}, {{"oiio:ColorSpace", "KodakLog"}});
        }),
        "f.dpx: its colours are encoded as 'KodakLog'; accepted are linear ones, sRGB, Rec709 and powers, and any "
        "as raw numbers");
    EXPECT_EQ(message([&] {
                  texel("g.exr", {"X", "Y", "Z"}, {1, 1, 1});
              }),
              "g.exr: has channels X, Y and Z; accepted for a texture are R, G and B, or Y");
}

TEST_F(Textures, WhatCannotBeDecodedIsNamed) {
    const description::Texture texture{
        .kind = description::Bitmap{.file = write("a.png", "no image")}, .to_uv = {}, .place = {"scene.xml", 3}};
    EXPECT_EQ(message([&] { return TextureLookup(texture).at(0, 0); }).substr(0, 19), "scene.xml:3: a.png:");
    EXPECT_EQ(message([&] { return read_texels(path_ / "b.png"); }), "b.png: there is no such file");
}

}  // namespace
}  // namespace plumb
