#pragma once

#include <array>
#include <vector>

#include "checks/bsdf/bsdf_subject.h"

namespace plumb::checks {

/// An interval of u[0] within which sample() does one thing for given wo, u[1], u[2].
struct Lobe {
    double from, to;
    std::optional<BsdfSample> sample;

    [[nodiscard]] double share() const { return to - from; }
    [[nodiscard]] double middle() const { return (from + to) / 2; }
    [[nodiscard]] bool smooth() const { return sample && sample->measure == Measure::solid_angle; }
    [[nodiscard]] bool discrete() const { return sample && sample->measure == Measure::discrete; }
};

/// Whether two outcomes come from one lobe: both lost, or alike in measure, side, index and roughness.
bool same_lobe(const std::optional<BsdfSample>& a, const std::optional<BsdfSample>& b);

/// All lobes whose share is not below 1e-6 at the ends of [0,1) and 1/16 inside, with their ends by bisection.
std::vector<Lobe> lobes(const BsdfSubject& bsdf, Vec3 wo, const std::array<double, 2>& u, Transport transport);

}  // namespace plumb::checks
