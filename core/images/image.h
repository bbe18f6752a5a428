#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace plumb {

/// How a file says that its numbers stand for amounts of light.
struct Encoding {
    std::string name = {};  ///< as OpenImageIO calls it: "Linear", "sRGB", …; empty where the file does not say
    double gamma = 0;       ///< of a power, where it is one; else 0
};

/// An image with named channels: rows from the top, each of `width` pixels, each of one number a channel. A decoded
/// image has the file's numbers, integers of b bits divided by 2^b − 1; no colour transform is applied, and colours are
/// not multiplied by an alpha that the file's colours do not contain.
struct Image {
    int width = 0, height = 0;
    std::vector<std::string> channels;  ///< names, e.g. R, G, B, A
    std::vector<float> values;
    std::map<std::string, std::string> metadata = {};  ///< attributes that are text
    bool of_integers = false;                          ///< how the file stores its numbers: integers, or floats
    Encoding encoding = {};

    [[nodiscard]] float at(int x, int y, std::size_t channel) const {
        return values[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                          channels.size() +
                      channel];
    }
};

/// Decodes any format that OpenImageIO reads, by what it means and not how it is laid out: the picture is the display
/// window of an EXR file (black where no data are), upright by the orientation that a file states, in RGB where it is
/// stored as luminance and chroma; the parts of an EXR file are layers of one image ("diffuse.R"), and of the pages,
/// frames or layers of any other format the first is the picture. Throws Error naming the file when there is none, when
/// it is not an image, truncated, deep, of three dimensions, larger than 2^30 numbers, of parts of unlike sizes, or a
/// WebP whose colours lost what its alpha hides.
Image read_image(const std::filesystem::path& file);

/// Throws Error naming the file and the first pixel and channel whose value is not finite.
void require_finite(const Image& image, const std::filesystem::path& file);

/// Throws Error where no image format has the file's extension: before the work of making one begins.
void check_image_format(const std::filesystem::path& file);

/// Encodes an image in the format of the file's extension, by write_aside() of core/file.h. EXR and TIFF keep floats,
/// names and metadata; other formats keep what they can. Throws Error naming the file.
void write_image(const std::filesystem::path& file, const Image& image);

}  // namespace plumb
