#pragma once

#include <array>
#include <memory>

#include "scenes/description/models.h"
#include "scenes/textures/texels.h"

namespace plumb {

struct BitmapLookup;

namespace description {

/// The continuation of a picture beyond its edges.
enum class Wrap { repeat, mirror, clamp };

/// A picture from a file, as a texture.
struct Bitmap {
    std::filesystem::path file;
    bool raw = false;  ///< values are taken as they are; else files of 8 and 16 bits are decoded as sRGB
    Wrap wrap = Wrap::repeat;

    static constexpr std::array plugins{Plugin{"bitmap", "a picture, looked up bilinearly"}};
    static Bitmap load(Properties& properties);
    /// The bitmap ready for lookups: reads the file. Throws Error naming it.
    [[nodiscard]] BitmapLookup prepared() const;
};

}  // namespace description

/// The value at (u, v), bilinear between texel centres at ((i + 1/2)/width, (j + 1/2)/height); v = 0 is the top edge.
Spectrum bilinear(const Texels& texels, description::Wrap wrap, double u, double v);

/// A bitmap ready for lookups. It is a value; copies share the picture.
struct BitmapLookup {
    std::shared_ptr<const Texels> texels;
    description::Wrap wrap;

    [[nodiscard]] Spectrum at(double u, double v) const { return bilinear(*texels, wrap, u, v); }
};

}  // namespace plumb
