#include "core/images/image.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

#include "core/error.h"

namespace plumb {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

class ReadImage : public testing::Test {
protected:
    ReadImage() { fs::create_directories(folder_); }
    ~ReadImage() override { fs::remove_all(folder_); }

    fs::path path(const std::string& name) const { return folder_ / name; }

    // A picture of 64 × 48 pixels, channels R, G, B, whose numbers differ from pixel to pixel.
    fs::path written(const std::string& name, OIIO::TypeDesc type, float last = 0.5f) const {
        OIIO::ImageSpec spec(64, 48, 3, type);
        std::vector<float> pixels(64 * 48 * 3);
        for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<float>(i * i % 251) / 255.0f;
        pixels.back() = last;
        OIIO::attribute("threads", 1);  // as the reader does
        OIIO::attribute("exr_threads", -1);
        auto out = OIIO::ImageOutput::create(path(name).string());
        EXPECT_TRUE(out && out->open(path(name).string(), spec) &&
                    out->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && out->close());
        return path(name);
    }

    static std::string complaint(const fs::path& file) {
        try {
            require_finite(read_image(file), file);
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            return error.what();
        }
        return "";
    }

private:
    fs::path folder_ = fs::temp_directory_path() / fmt::format("plumb-image-{}", ::getpid());
};

TEST_F(ReadImage, GivesTheNumbersOfTheFile) {
    for (const char* name : {"a.exr", "a.png", "a.tif"}) {
        const Image image =
            read_image(written(name, name == std::string("a.exr") ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8));
        EXPECT_EQ(image.width, 64) << name;
        EXPECT_EQ(image.height, 48) << name;
        EXPECT_THAT(image.channels, ElementsAre("R", "G", "B")) << name;
        const std::size_t i = (10 * 64 + 7) * 3 + 1;  // pixel (7, 10), G
        EXPECT_NEAR(image.at(7, 10, 1), static_cast<float>(i * i % 251) / 255.0f, 1e-6) << name;
    }
}

// A picture of 4 × 3 pixels of red, green, blue and alpha that 8 bits hold, in every encoding that keeps it.
class Encodings : public ReadImage {
protected:
    static std::array<float, 4> colour(int x, int y) {
        return {static_cast<float>(200 - 9 * x) / 255, static_cast<float>(100 + 20 * y) / 255, 50.f / 255, 128.f / 255};
    }

    fs::path write(const std::string& name, const OIIO::ImageSpec& spec) const {
        std::vector<float> values;
        for (int y = spec.y; y < spec.y + spec.height; ++y)
            for (int x = spec.x; x < spec.x + spec.width; ++x)
                for (const std::string& channel : spec.channelnames)
                    values.push_back(colour(x, y)[std::string("RGBA").find(channel)]);
        OIIO::attribute("threads", 1);  // as the reader does
        OIIO::attribute("exr_threads", -1);
        const auto out = OIIO::ImageOutput::create(path(name).string());
        EXPECT_TRUE(out && out->open(path(name).string(), spec) &&
                    out->write_image(OIIO::TypeDesc::FLOAT, values.data()) && out->close())
            << name;
        return path(name);
    }

    static OIIO::ImageSpec spec(OIIO::TypeDesc type, std::vector<std::string> channels = {"R", "G", "B", "A"}) {
        OIIO::ImageSpec spec(4, 3, static_cast<int>(channels.size()), type);
        spec.channelnames = std::move(channels);
        spec.attribute("oiio:UnassociatedAlpha", 1);  // else the writer divides colours by alpha
        return spec;
    }
};

TEST_F(Encodings, AllReadTheSame) {
    OIIO::ImageSpec tiled = spec(OIIO::TypeDesc::HALF), window = spec(OIIO::TypeDesc::FLOAT);
    tiled.tile_width = tiled.tile_height = 16;
    window.x = window.y = -1;
    window.width = 6;
    window.height = 5;
    window.full_width = 4;
    window.full_height = 3;
    const std::vector<std::pair<std::string, OIIO::ImageSpec>> layouts{
        {"a.png", spec(OIIO::TypeDesc::UINT8)},
        {"b.png", spec(OIIO::TypeDesc::UINT16)},
        {"c.tif", spec(OIIO::TypeDesc::UINT8)},
        {"d.tif", spec(OIIO::TypeDesc::FLOAT)},
        {"e.tif", spec(OIIO::TypeDesc::DOUBLE)},
        {"f.exr", spec(OIIO::TypeDesc::FLOAT)},
        {"g.exr", spec(OIIO::TypeDesc::HALF, {"A", "B", "G", "R"})},
        {"h.exr", tiled},
        {"i.exr", window},
        {"j.tga", spec(OIIO::TypeDesc::UINT8)},
        {"k.bmp", spec(OIIO::TypeDesc::UINT8)},
        {"l.ppm", spec(OIIO::TypeDesc::UINT8, {"R", "G", "B"})},
        {"m.sgi", spec(OIIO::TypeDesc::UINT16)},
        {"n.dpx", spec(OIIO::TypeDesc::UINT16)},
        {"o.png", spec(OIIO::TypeDesc::UINT8, {"R", "G", "B"})}};
    for (const auto& [name, layout] : layouts) {
        const Image image = read_image(write(name, layout));
        ASSERT_EQ(image.width, 4) << name;
        ASSERT_EQ(image.height, 3) << name;
        ASSERT_GE(image.channels.size(), 3u) << name;
        for (std::size_t c = 0; c < image.channels.size(); ++c) {
            const std::size_t which = std::string("RGBA").find(image.channels[c]);
            ASSERT_LT(which, 4u) << name;
            for (int y = 0; y < 3; ++y)
                for (int x = 0; x < 4; ++x)
                    EXPECT_NEAR(image.at(x, y, c), colour(x, y)[which], 1e-3) << name << ", " << image.channels[c];
        }
    }
}

TEST_F(Encodings, TellWhatTheirNumbersAre) {
    OIIO::ImageSpec linear = spec(OIIO::TypeDesc::UINT8), power = linear;
    linear.attribute("oiio:ColorSpace", "Linear");
    power.attribute("oiio:ColorSpace", "GammaCorrected1.8");
    power.attribute("oiio:Gamma", 1.8f);
    EXPECT_EQ(read_image(write("a.png", linear)).encoding.name, "Linear");
    EXPECT_NEAR(read_image(write("b.png", power)).encoding.gamma, 1.8, 1e-3);
    EXPECT_EQ(read_image(write("c.png", spec(OIIO::TypeDesc::UINT8))).encoding.name, "sRGB");
}

TEST_F(Encodings, OfSeveralPartsAreLayers) {
    OIIO::ImageSpec a = spec(OIIO::TypeDesc::FLOAT, {"R", "G", "B"}), b = spec(OIIO::TypeDesc::FLOAT, {"A"});
    a.attribute("oiio:subimagename", "diffuse");
    b.attribute("oiio:subimagename", "cover");
    const std::vector<OIIO::ImageSpec> specs{a, b};
    const std::string file = path("parts.exr").string();
    const std::vector<float> values(36, 0.5f);
    const auto out = OIIO::ImageOutput::create(file);
    ASSERT_TRUE(out && out->open(file, 2, specs.data()) && out->write_image(OIIO::TypeDesc::FLOAT, values.data()) &&
                out->open(file, b, OIIO::ImageOutput::AppendSubimage) &&
                out->write_image(OIIO::TypeDesc::FLOAT, values.data()) && out->close());
    EXPECT_THAT(read_image(file).channels, ElementsAre("diffuse.R", "diffuse.G", "diffuse.B", "cover.A"));
}

TEST_F(ReadImage, RefusesATruncatedFile) {
#ifdef __SANITIZE_ADDRESS__  // OpenImageIO's PNG reader jumps over the destructor of a string
    const std::vector<const char*> names = {"a.exr", "a.tif", "a.jpg", "a.hdr", "a.tga", "a.bmp", "a.ppm", "a.dpx"};
#else
    const std::vector<const char*> names = {"a.exr", "a.png", "a.tif", "a.jpg", "a.hdr",
                                            "a.tga", "a.bmp", "a.ppm", "a.dpx"};
#endif
    for (const char* name : names) {
        const fs::path file = written(name, OIIO::TypeDesc::UINT8);
        ASSERT_EQ(complaint(file), "") << name;
        fs::resize_file(file, fs::file_size(file) / 2);
        EXPECT_THAT(complaint(file), AllOf(HasSubstr(name), HasSubstr("not a readable image"))) << name;
        fs::resize_file(file, 3);
        EXPECT_THAT(complaint(file), HasSubstr("not a readable image")) << name;
        fs::resize_file(file, 0);
        EXPECT_THAT(complaint(file), HasSubstr("not a readable image")) << name;
    }
}

TEST_F(ReadImage, RefusesWhatIsNoImage) {
    EXPECT_THAT(complaint(path("missing.png")), HasSubstr("no such file"));
    EXPECT_THAT(complaint(path("")), HasSubstr("not a readable image"));  // the folder
}

TEST_F(ReadImage, NamesThePixelThatIsNoNumber) {
    const fs::path file = written("a.exr", OIIO::TypeDesc::FLOAT, std::numeric_limits<float>::quiet_NaN());
    EXPECT_THAT(complaint(file), HasSubstr("pixel (63, 47), channel B is nan"));
}

}  // namespace
}  // namespace plumb
