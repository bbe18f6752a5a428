#pragma once

#include <cstdint>
#include <variant>

#include "core/spectrum.h"

namespace plumb::description {

/// An index into a scene's textures.
struct TextureId {
    std::uint32_t index = 0;
    friend bool operator==(TextureId, TextureId) = default;
};
/// An index into a scene's materials.
struct MaterialId {
    std::uint32_t index = 0;
    friend bool operator==(MaterialId, MaterialId) = default;
};

/// A number of a material for each wavelength: the same everywhere, or a texture's at the hit.
using Colour = std::variant<Spectrum, TextureId>;

}  // namespace plumb::description
