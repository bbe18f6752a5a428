#pragma once

#include <vector>

#include "scenes/bsdfs/bsdf.h"

namespace plumb {

/// The materials of a scene, ready to be resolved into closures: textures are read, tables of rough coats are made.
class Materials {
public:
    /// Throws Error naming file and line for a bitmap that cannot be read and for what no closure can do.
    Materials(const std::vector<description::Material>& materials, const std::vector<description::Texture>& textures);

    /// The closure at the texture coordinates uv, as seen from outside or from inside.
    [[nodiscard]] Bsdf at(description::MaterialId material, const std::array<double, 2>& uv, bool outside) const;
    /// The chance that a ray meets the surface at all: below 1 for masks.
    [[nodiscard]] double opacity(description::MaterialId material, const std::array<double, 2>& uv) const;
    [[nodiscard]] bool is_mask(description::MaterialId material) const;

private:
    using Prepared = description::Prepared<description::OneOf<description::MaterialModels>>;

    std::vector<Prepared> materials_;
    std::vector<TextureLookup> textures_;
};

}  // namespace plumb
