#pragma once

#include "checks/bsdf/check_bsdf.h"

namespace plumb::suites {

// Defects that a surface of any model can have, as renderers have had them: each makes a wrong model out of a right
// one.

/// A surface on trial.
struct SurfaceSubject {
    std::string name;
    checks::BsdfSubject bsdf;
    checks::BsdfTraits traits;
};
using Defect = std::function<checks::BsdfSubject(const SurfaceSubject&)>;

/// A defect and the property that it breaks.
struct NamedDefect {
    std::string property, id, sentence;
    Defect apply;
};

/// The model with a change to every sample that it makes.
checks::BsdfSubject with_samples(const SurfaceSubject& s,
                                 const std::function<void(BsdfSample&, Vec3 wo, Transport)>& change);
/// The model with the weights and values of radiance and importance multiplied by a factor of the sides: eta is that of
/// the crossing.
checks::BsdfSubject scaled(const SurfaceSubject& s,
                           const std::function<double(double eta, bool crosses, Transport)>& factor);

checks::BsdfSubject eval_swapped(const SurfaceSubject& s);
checks::BsdfSubject eta_squared_missing(const SurfaceSubject& s);
checks::BsdfSubject eta_squared_on_both_sides(const SurfaceSubject& s);
checks::BsdfSubject eta_squared_upside_down(const SurfaceSubject& s);
checks::BsdfSubject transmission_doubled(const SurfaceSubject& s);
checks::BsdfSubject weight_without_share(const SurfaceSubject& s);
checks::BsdfSubject chosen_too_often(const SurfaceSubject& s);

/// The defects that every smoothly scattering surface can have; `energy_factor` makes it brighter than its energy's
/// claim allows.
std::vector<NamedDefect> common_defects(double energy_factor);
/// The same defects for surfaces whose lobes overlap, where pdf() can only be known to be too small.
std::vector<NamedDefect> defects_of_mixtures(double energy_factor);
/// The defects that mirrors and smooth interfaces can have.
std::vector<NamedDefect> discrete_defects();

}  // namespace plumb::suites
