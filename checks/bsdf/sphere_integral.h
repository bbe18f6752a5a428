#pragma once

#include <functional>
#include <span>
#include <vector>

#include "checks/bsdf/cubature.h"
#include "core/vec3.h"

namespace plumb::checks {

/// The integral of a function over the sphere of directions, in parts that are the smaller the more it varies: an
/// adaptive cubature in the polar angle and the azimuth from the plane of incidence. It finds a peak, however narrow,
/// where one of the given directions has met it, and owns the error of an edge.
class SphereIntegral {
public:
    /// Of f, for wo; `met` are directions where f may peak. The error is below 2e-5 unless that takes more than
    /// `evaluations` of f. No part is larger than `largest`.
    SphereIntegral(Vec3 wo, const std::function<double(Vec3)>& f, std::span<const Vec3> met, std::size_t evaluations,
                   double largest = std::numeric_limits<double>::infinity());

    [[nodiscard]] double total() const { return cubature_.total; }
    [[nodiscard]] double error() const { return cubature_.error; }

    [[nodiscard]] std::size_t parts() const { return cubature_.parts.size(); }
    [[nodiscard]] const Region& part(std::size_t i) const { return cubature_.regions[cubature_.parts[i]]; }
    /// The part that w lies in.
    [[nodiscard]] std::size_t part_of(Vec3 w) const { return cubature_.part_at(place(w)); }
    [[nodiscard]] Vec3 middle(std::size_t i) const;

private:
    [[nodiscard]] Place place(Vec3 w) const;
    [[nodiscard]] Vec3 direction(double polar, double azimuth) const;

    Vec3 forward_;  // horizontal, away from wo
    Cubature cubature_;
};

}  // namespace plumb::checks
