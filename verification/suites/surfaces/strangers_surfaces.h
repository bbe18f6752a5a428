#pragma once

#include <string>
#include <vector>

#include "checks/bsdf/check_bsdf.h"

namespace plumb::suites {

// Surfaces as strangers write them, for check_bsdf on trial: true ones that a check of lobes, edges, mixtures or
// rounding could take for wrong, and wrong ones that it could take for true.

/// A lobe f = norm · cos^n of the angle to an axis, in any direction: the axis is wo itself (a retro-reflector) or wo
/// mirrored at a normal of any tilt. What leaves below the surface is scattered there, or lost.
struct NarrowLobe {
    double exponent = 1000;
    Vec3 normal{0, 0, 1};
    bool retro = false, below = false;

    [[nodiscard]] Vec3 axis(Vec3 wo) const { return retro ? wo : mirrored(wo, normal); }
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi) const { return Spectrum::grey(pdf(wo, wi) * std::abs(wi.z)); }
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u) const;
};

/// The same density everywhere within a cone about the mirrored direction, none outside.
struct Cone {
    double cosine = 0.98;

    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi) const { return Spectrum::grey(pdf(wo, wi) * std::abs(wi.z)); }
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u) const;
};

/// A diffuse surface with a mirror, which is chosen for u[0] in [from, to) and returns `light` in all. It does not
/// tell how often.
struct DiffuseWithMirror {
    double albedo = 0.6, light = 0.3, from = 0, to = 0.3;

    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u) const;
};

/// A metal of GGX facets without absorption, stretched along x, whose arithmetic is Real's throughout: D by the cosine,
/// as most renderers have it, V-cavities for masking [Cook & Torrance 1982], samples of all normals.
template <class Real>
struct Metal {
    Real along = Real(0.1), across = Real(0.1);

    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u) const;
};

/// A surface on trial.
struct StrangersSurface {
    std::string id;
    checks::BsdfSubject bsdf;
    checks::BsdfTraits traits = {};
    bool quick = false;  ///< of a true one: the quick size integrates over it, too
};

/// A surface with one defect, and the property that it breaks.
struct WrongStrangersSurface {
    std::string property, sentence;
    StrangersSurface surface;
};

/// True surfaces that are narrow, tilted, cut off, mixed, or in floats.
std::vector<StrangersSurface> true_surfaces_of_strangers();
std::vector<WrongStrangersSurface> wrong_surfaces_of_strangers();

}  // namespace plumb::suites
