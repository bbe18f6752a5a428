#pragma once

#include <array>
#include <vector>

#include "checks/bsdf/bsdf_subject.h"
#include "core/random.h"

namespace plumb::checks {

/// An interval of u[0] within which sample() does one thing for given wo, u[1], u[2].
struct Lobe {
    double from, to;
    std::optional<BsdfSample> sample;
    double share = 0;  ///< of all intervals that do the same

    [[nodiscard]] double middle() const { return (from + to) / 2; }
    [[nodiscard]] bool smooth() const { return sample && sample->measure == Measure::solid_angle; }
    [[nodiscard]] bool discrete() const { return sample && sample->measure == Measure::discrete; }
};

/// Whether two outcomes come from one lobe: both lost, or alike in measure, side, index and roughness.
bool same_lobe(const std::optional<BsdfSample>& a, const std::optional<BsdfSample>& b);
/// Whether they are alike in direction too: within a lobe u[0] does not move it.
bool same_outcome(const std::optional<BsdfSample>& a, const std::optional<BsdfSample>& b);

/// All lobes whose share is not below 1e-6 at the ends of [0,1) and 1/probes inside, with their ends by bisection; one
/// that is smaller, and between two others, is met too. The probes of u[0] lie at (i + offset)/probes.
std::vector<Lobe> lobes(const BsdfSubject& bsdf, Vec3 wo, const std::array<double, 2>& u, Transport transport,
                        double offset = 0.5, int probes = 64);

/// A discrete outcome that samples met, and how often.
struct Mirror {
    BsdfSample sample;
    std::size_t met;
};

/// What samples of one direction met.
struct Met {
    std::vector<Vec3> smooth;     ///< the directions of smooth samples
    std::vector<Mirror> mirrors;  ///< the different discrete ones
    std::size_t lost = 0;

    /// The probability of all mirrors, as their samples announce it.
    [[nodiscard]] double discrete() const;
};
Met met_by_samples(const BsdfSubject& bsdf, Vec3 wo, Transport transport, RandomStream& random, double epsilon,
                   int count);

}  // namespace plumb::checks
