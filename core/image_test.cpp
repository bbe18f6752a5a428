#include "core/image.h"

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
