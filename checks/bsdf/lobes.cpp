#include "checks/bsdf/lobes.h"

namespace plumb::checks {

bool same_lobe(const std::optional<BsdfSample>& a, const std::optional<BsdfSample>& b) {
    if (!a || !b) return !a && !b;
    return a->measure == b->measure && same_side(a->wi, b->wi) && a->eta == b->eta && a->roughness == b->roughness;
}

namespace {

// Whether both outcomes are the same: within a lobe u[0] does not move the direction.
bool same_outcome(const std::optional<BsdfSample>& a, const std::optional<BsdfSample>& b) {
    return same_lobe(a, b) && (!a || length_squared(a->wi - b->wi) < 1e-18);
}

}  // namespace

std::vector<Lobe> lobes(const BsdfSubject& bsdf, Vec3 wo, const std::array<double, 2>& u, Transport transport) {
    const auto outcome = [&](double u0) { return bsdf.sample(wo, {u0, u[0], u[1]}, transport); };
    std::vector<double> probes{1e-6};
    for (int i = 0; i < 16; ++i) probes.push_back((i + 0.5) / 16);
    probes.push_back(1 - 1e-6);
    std::vector<Lobe> found{{0, 1, outcome(probes[0])}};
    for (std::size_t i = 1; i < probes.size(); ++i) {
        const std::optional<BsdfSample> next = outcome(probes[i]);
        if (same_outcome(found.back().sample, next)) continue;
        double low = probes[i - 1], high = probes[i];
        for (int step = 0; step < 44; ++step) {
            const double middle = (low + high) / 2;
            (same_outcome(found.back().sample, outcome(middle)) ? low : high) = middle;
        }
        found.back().to = high;
        found.push_back({high, 1, next});
    }
    return found;
}

}  // namespace plumb::checks
