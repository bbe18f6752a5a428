#pragma once

#include <array>

#include "scenes/bsdfs/microfacet.h"

namespace plumb {

/// The share of light that a rough dielectric coat does not reflect in one scattering, as a function of cosθ: a table,
/// one for each material. It is linear between nodes at cosθ = (k/nodes)², which lie closest where the function bends:
/// at grazing angles.
class RoughTransmittance {
public:
    /// The table for a coat whose index over that outside is eta > 1.
    RoughTransmittance(const Microfacets& facets, double eta);

    [[nodiscard]] double at(double cosine) const;
    /// The share of a diffuse base's light that the coat sends back to it: 1 − mean/eta², by the equilibrium of uniform
    /// light on both sides of the coat, where mean is the mean of at() over uniform light from outside.
    [[nodiscard]] double returned() const { return returned_; }
    [[nodiscard]] const Microfacets& facets() const { return facets_; }
    [[nodiscard]] double eta() const { return eta_; }

private:
    static constexpr std::size_t nodes = 64;
    Microfacets facets_;
    double eta_, returned_;
    std::array<double, nodes + 1> values_;
};

}  // namespace plumb
