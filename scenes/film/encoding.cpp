#include "scenes/film/encoding.h"

#include "core/srgb.h"

namespace plumb {

Image encoded_for(const std::filesystem::path& file, const Image& image) {
    const std::string format = file.extension().string();
    if (format == ".exr" || format == ".tif" || format == ".tiff") return image;
    const bool linear = format == ".hdr" || format == ".pfm";
    const auto srgb = [](float x) { return srgb_from_linear(std::clamp(x, 0.f, 1.f)); };
    Image colours{image.width, image.height, {"R", "G", "B"}, {}, image.metadata};
    for (std::size_t i = 0; i < image.values.size(); i += image.channels.size())
        for (std::size_t c = 0; c < 3; ++c)
            colours.values.push_back(linear ? image.values[i + c] : srgb(image.values[i + c]));
    return colours;
}

}  // namespace plumb
