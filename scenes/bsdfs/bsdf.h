#pragma once

#include <variant>

#include "scenes/bsdfs/conductor.h"
#include "scenes/bsdfs/dielectric.h"
#include "scenes/bsdfs/diffuse.h"
#include "scenes/bsdfs/plastic.h"
#include "scenes/bsdfs/roughconductor.h"
#include "scenes/bsdfs/roughdielectric.h"
#include "scenes/bsdfs/roughplastic.h"

namespace plumb {

/// What a surface does to light at one point: the closure of numbers that a material becomes there
/// (scenes/bsdfs/materials.h), under the conventions of scenes/bsdfs/bsdf_model.h.
struct Bsdf {
    using Model = std::variant<Diffuse, Conductor, Dielectric, RoughConductor, RoughDielectric, Plastic, RoughPlastic>;

    Model model;
    bool two_sided = false;  ///< what the model does above, it does below, mirrored at the surface

    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi, Transport transport) const {
        return std::visit([&](const auto& m) { return m.eval(turned(wo, wo), turned(wi, wo), transport); }, model);
    }
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const {
        return std::visit([&](const auto& m) { return m.pdf(turned(wo, wo), turned(wi, wo)); }, model);
    }
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const {
        auto sample = std::visit([&](const auto& m) { return m.sample(turned(wo, wo), u, transport); }, model);
        if (sample) sample->wi = turned(sample->wi, wo);
        return sample;
    }
    [[nodiscard]] double discrete(Vec3 wo) const {
        return std::visit([&](const auto& m) { return m.discrete(turned(wo, wo)); }, model);
    }
    /// Whether it has a smooth part: what only mirrors needs no light to be sampled.
    [[nodiscard]] bool smooth() const {
        return !std::holds_alternative<Conductor>(model) && !std::holds_alternative<Dielectric>(model);
    }

private:
    /// w as the model sees it when wo shall be above.
    [[nodiscard]] Vec3 turned(Vec3 w, Vec3 wo) const { return two_sided && wo.z < 0 ? Vec3{w.x, w.y, -w.z} : w; }
};

static_assert(BsdfModel<Bsdf>);

/// What a denoiser or a person takes for the surface's colour: the reflectance of what scatters, grey 1 for glass.
Spectrum albedo(const Bsdf& bsdf);

/// The least roughness of the lobes of the smooth part, which a BsdfSample states of one: 1 of a diffuse one, 0 where
/// there is no smooth part.
double smooth_roughness(const Bsdf& bsdf);

/// The index on wi's side over the index on wo's side, as a BsdfSample of the smooth part would state it.
double eta_between(const Bsdf& bsdf, Vec3 wo, Vec3 wi);

}  // namespace plumb
