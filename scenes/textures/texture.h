#pragma once

#include <vector>

#include "scenes/description/prepared.h"
#include "scenes/textures/all.h"

namespace plumb {

namespace description {

/// A texture as the file has it.
struct Texture {
    OneOf<TextureModels> kind;
    Transform to_uv;  ///< of a surface's (u, v, 0) before the lookup
    Place place;
};

}  // namespace description

/// A texture ready for lookups. It is a value; copies share its picture.
class TextureLookup {
public:
    /// Prepares the model; a bitmap's file is read. Throws Error with the texture's place.
    explicit TextureLookup(const description::Texture& texture);
    [[nodiscard]] Spectrum at(double u, double v) const;

private:
    description::Prepared<description::OneOf<description::TextureModels>> model_;
    Transform to_uv_;
};

/// The colour at a hit's uv, looked up in the textures of its scene.
Spectrum value(const description::Colour& colour, const std::vector<TextureLookup>& textures, double u, double v);

}  // namespace plumb
