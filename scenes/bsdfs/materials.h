#pragma once

#include <optional>
#include <vector>

#include "scenes/bsdfs/bsdf.h"
#include "scenes/bsdfs/texture.h"

namespace plumb {

/// The materials of a scene, ready to be resolved into closures: textures are read, tables of rough coats made.
class Materials {
public:
    /// Throws Error naming file and line for a bitmap that cannot be read and for what no closure can do.
    explicit Materials(const description::Scene& scene);

    /// The closure at the texture coordinates uv, as seen from outside or from inside.
    [[nodiscard]] Bsdf at(description::MaterialId material, const std::array<double, 2>& uv, bool outside) const;
    /// The chance that a ray meets the surface at all: below 1 for masks.
    [[nodiscard]] double opacity(description::MaterialId material, const std::array<double, 2>& uv) const;
    [[nodiscard]] bool is_mask(description::MaterialId material) const;

private:
    [[nodiscard]] Spectrum colour(const description::Colour& colour, const std::array<double, 2>& uv) const {
        return value(colour, textures_, uv[0], uv[1]);
    }
    struct Where {
        description::MaterialId material;
        std::array<double, 2> uv;
        bool outside;
    };
    [[nodiscard]] Bsdf resolved(const description::Diffuse& diffuse, const Where& at) const;
    [[nodiscard]] Bsdf resolved(const description::Conductor& conductor, const Where& at) const;
    [[nodiscard]] Bsdf resolved(const description::Dielectric& dielectric, const Where& at) const;
    [[nodiscard]] Bsdf resolved(const description::Plastic& plastic, const Where& at) const;
    [[nodiscard]] Bsdf resolved(const description::TwoSided& sides, const Where& at) const;
    [[nodiscard]] Bsdf resolved(const description::Mask& mask, const Where& at) const;

    std::vector<description::Material> materials_;
    std::vector<TextureLookup> textures_;
    // Of the material of that index, where it is a plastic.
    std::vector<std::optional<SmoothCoat>> smooth_coats_;
    std::vector<std::optional<RoughTransmittance>> rough_coats_;
};

}  // namespace plumb
