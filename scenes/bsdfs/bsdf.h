#pragma once

#include <variant>

#include "scenes/bsdfs/all.h"

namespace plumb {

/// What a surface does to light at one point: the closure of numbers that a material becomes there
/// (scenes/bsdfs/materials.h), under the conventions of scenes/bsdfs/bsdf_model.h.
struct Bsdf {
    using Model = description::OneOf<Closures>;

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
    /// Whether it has a smooth part: a surface of mirrors alone needs no sample of a light.
    [[nodiscard]] bool smooth() const {
        return std::visit([](const auto& m) { return m.smooth; }, model);
    }
    /// The closure's plugin in Mitsuba's XML, e.g. "roughconductor".
    [[nodiscard]] std::string_view name() const {
        return std::visit([](const auto& m) { return m.name; }, model);
    }

private:
    /// The direction w as the model sees it when wo is turned above the surface.
    [[nodiscard]] Vec3 turned(Vec3 w, Vec3 wo) const { return two_sided && wo.z < 0 ? Vec3{w.x, w.y, -w.z} : w; }
};

static_assert(BsdfModel<Bsdf>);

/// The colour that a denoiser or a person takes for the surface's: the reflectance of what scatters, grey 1 for glass.
inline Spectrum albedo(const Bsdf& bsdf) {
    return std::visit([](const auto& m) { return m.albedo(); }, bsdf.model);
}

/// The least roughness of the lobes of the smooth part (NamedBsdfModel).
inline double smooth_roughness(const Bsdf& bsdf) {
    return std::visit([](const auto& m) { return m.roughness(); }, bsdf.model);
}

/// The index on wi's side over the index on wo's side, as a BsdfSample of the smooth part would state it: 1 for models
/// that do not refract smoothly.
inline double eta_between(const Bsdf& bsdf, Vec3 wo, Vec3 wi) {
    return std::visit(
        [&](const auto& m) {
            if constexpr (requires { m.eta_between(wo, wi); })
                return m.eta_between(wo, wi);
            else
                return 1.0;
        },
        bsdf.model);
}

}  // namespace plumb
