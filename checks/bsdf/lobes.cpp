#include "checks/bsdf/lobes.h"

#include "checks/bsdf/arithmetic.h"

namespace plumb::checks {

bool same_lobe(const std::optional<BsdfSample>& a, const std::optional<BsdfSample>& b) {
    if (!a || !b) return !a && !b;
    return a->measure == b->measure && same_side(a->wi, b->wi) && a->eta == b->eta && a->roughness == b->roughness;
}

bool same_outcome(const std::optional<BsdfSample>& a, const std::optional<BsdfSample>& b) {
    return same_lobe(a, b) && (!a || length_squared(a->wi - b->wi) < 1e-18);
}

namespace {

// The lobes in order, each interval by itself.
std::vector<Lobe> intervals(const std::function<std::optional<BsdfSample>(double u0)>& outcome,
                            const std::vector<double>& probes) {
    constexpr std::size_t most = 64;  // of a model that moves its direction by u[0]
    std::vector<Lobe> found{{0, 1, outcome(probes[0])}};
    for (std::size_t i = 1; i < probes.size(); ++i) {
        const std::optional<BsdfSample> next = outcome(probes[i]);
        for (double from = probes[i - 1]; !same_outcome(found.back().sample, next) && found.size() < most;) {
            double low = from, high = probes[i];
            for (int step = 0; step < 44; ++step) {
                const double middle = (low + high) / 2;
                (same_outcome(found.back().sample, outcome(middle)) ? low : high) = middle;
            }
            found.back().to = from = high;
            found.push_back({high, 1, outcome(high)});
        }
    }
    return found;
}

}  // namespace

std::vector<Lobe> lobes(const BsdfSubject& bsdf, Vec3 wo, const std::array<double, 2>& u, Transport transport,
                        double offset, int count) {
    std::vector<double> probes{1e-6};
    for (int i = 0; i < count; ++i) probes.push_back((i + offset) / count);
    probes.push_back(1 - 1e-6);
    std::vector<Lobe> joined;
    for (const Lobe& interval : intervals(
             [&](double u0) {
                 return bsdf.sample(wo, {u0, u[0], u[1]}, transport);
             },
             probes)) {
        const auto same = [&](const Lobe& lobe) { return same_outcome(lobe.sample, interval.sample); };
        auto lobe = std::ranges::find_if(joined, same);
        if (lobe == joined.end()) lobe = joined.insert(joined.end(), interval);
        lobe->share += interval.to - interval.from;
    }
    return joined;
}

double Met::discrete() const {
    double sum = 0;
    for (const Mirror& mirror : mirrors) sum += mirror.sample.pdf;
    return sum;
}

Met met_by_samples(const BsdfSubject& bsdf, Vec3 wo, Transport transport, RandomStream& random, double epsilon,
                   int count) {
    Met met;
    for (int i = 0; i < count; ++i) {
        const auto sample = bsdf.sample(wo, uniforms(random, epsilon), transport);
        if (!sample) {
            ++met.lost;
        } else if (sample->measure == Measure::solid_angle) {
            met.smooth.push_back(sample->wi);
        } else {
            const auto same = [&](const Mirror& mirror) { return same_outcome(mirror.sample, sample); };
            auto mirror = std::ranges::find_if(met.mirrors, same);
            if (mirror == met.mirrors.end()) mirror = met.mirrors.insert(met.mirrors.end(), {*sample, 0});
            ++mirror->met;
        }
    }
    return met;
}

}  // namespace plumb::checks
