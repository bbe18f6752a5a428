#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <variant>
#include <vector>

#include "scenes/description/description.h"

namespace plumb {

/// Linear RGB texels, row by row from the top. Greys are three equal numbers; alpha is dropped.
struct Texels {
    int width = 0, height = 0;
    std::vector<float> rgb;  ///< 3·width·height

    [[nodiscard]] Spectrum texel(int x, int y) const {
        const float* p = rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                           static_cast<std::size_t>(x));
        return Spectrum::rgb(p[0], p[1], p[2]);
    }
};

/// Any file that OpenImageIO decodes. Integer texels are taken as sRGB and made linear, unless raw; floats are taken as
/// they are. Throws Error naming the file for what it cannot decode, and for texels that are NaN, infinite or negative.
Texels read_texels(const std::filesystem::path& file, bool raw = false);

/// Bilinear between texel centers at ((i + 1/2)/width, (j + 1/2)/height); v = 0 is the top edge.
Spectrum bilinear(const Texels& texels, description::Wrap wrap, double u, double v);

/// A texture ready for lookups: a value; images are shared.
class TextureLookup {
public:
    /// Reads the file of a bitmap. Throws Error with the texture's place.
    explicit TextureLookup(const description::Texture& texture);
    [[nodiscard]] Spectrum at(double u, double v) const;

private:
    struct Picture {
        std::shared_ptr<const Texels> texels;
        description::Wrap wrap;
    };
    std::variant<Picture, description::Checkerboard> kind_;
    Transform to_uv_;
};

/// All textures of a scene, in its order.
std::vector<TextureLookup> texture_lookups(const description::Scene& scene);

/// A colour at a hit's uv.
Spectrum value(const description::Colour& colour, const std::vector<TextureLookup>& textures, double u, double v);

}  // namespace plumb
