#pragma once

#include <cstdint>
#include <variant>

#include "core/spectrum.h"

namespace plumb::description {

/// An index into a scene's textures, and one into its materials.
struct TextureId {
    std::uint32_t index = 0;
    friend bool operator==(TextureId, TextureId) = default;
};
struct MaterialId {
    std::uint32_t index = 0;
    friend bool operator==(MaterialId, MaterialId) = default;
};

/// A number of a material for each wavelength: the same everywhere, or looked up at the hit.
using Colour = std::variant<Spectrum, TextureId>;

}  // namespace plumb::description
