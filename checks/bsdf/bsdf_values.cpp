#include <cmath>

#include "checks/bsdf/check_bsdf.h"
#include "estimators/densities/warps.h"
#include "verification/evidence/deterministic.h"

namespace plumb::checks {
namespace {

bool is_density(double value) {
    return value >= 0 && std::isfinite(value);
}
bool is_spectrum(const Spectrum& s) {
    return std::ranges::all_of(s.lane, is_density);
}
std::string printed(const Spectrum& s) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g}, {:.6g})", s[0], s[1], s[2], s[3]);
}
std::string printed(Vec3 w) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", w.x, w.y, w.z);
}

/// What is wrong with eval() and pdf() for these directions; empty where nothing is.
std::string fault_at(const BsdfSubject& bsdf, Vec3 wo, Vec3 wi) {
    const double pdf = bsdf.pdf(wo, wi);
    if (!is_density(pdf)) return fmt::format("pdf() is {:.6g}", pdf);
    for (const Transport transport : {Transport::importance, Transport::radiance}) {
        const Spectrum value = bsdf.eval(wo, wi, transport);
        if (!is_spectrum(value)) return fmt::format("eval() is {}", printed(value));
        if (largest(value) > 0 && pdf == 0)
            return fmt::format("eval() is {} where pdf() is 0, so that no sample finds it", printed(value));
    }
    return {};
}

std::string fault_of(const BsdfSample& sample) {
    const bool discrete = sample.measure == Measure::discrete;
    if (!(std::abs(length(sample.wi) - 1) < 1e-9))
        return fmt::format("sample() gives the direction {} of length {:.12g}", printed(sample.wi), length(sample.wi));
    if (!(is_density(sample.pdf) && sample.pdf > 0 && !(discrete && sample.pdf > 1 + 1e-9)))
        return fmt::format("sample() gives the {} {:.6g}", discrete ? "probability" : "pdf", sample.pdf);
    if (!is_spectrum(sample.weight)) return fmt::format("sample() gives the weight {}", printed(sample.weight));
    if (!(sample.eta > 0 && std::isfinite(sample.eta))) return fmt::format("sample() gives the eta {}", sample.eta);
    return {};
}

Verdict refuted(std::uint64_t cases, const std::string& fault, Vec3 wo, Vec3 wi) {
    return exactly(false, cases, fmt::format("{} (wo {}, wi {})", fault, name_of(wo), printed(wi)));
}

}  // namespace

Verdict values_are_sound(const BsdfSubject& bsdf, const Run& run) {
    constexpr int tries = 256;
    const std::vector<Vec3> directions = check_directions();
    std::uint64_t cases = 0;
    bool scatters = false;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const Vec3 wo = directions[i];
        const double discrete = bsdf.discrete ? bsdf.discrete(wo) : 0;
        if (!(discrete >= 0 && discrete <= 1 + 1e-9))
            return exactly(false, cases, fmt::format("discrete() is {:.6g} (wo {})", discrete, name_of(wo)));
        RandomStream random = run.random(i);
        std::optional<Vec3> promised;  // where pdf() says that samples go
        bool sampled = false;
        for (int k = 0; k < tries; ++k, ++cases) {
            const Vec3 wi = sample_uniform_sphere({random.uniform(), random.uniform()});
            if (const std::string fault = fault_at(bsdf, wo, wi); !fault.empty()) return refuted(cases, fault, wo, wi);
            if (bsdf.pdf(wo, wi) > 0) promised = wi;
            const std::array<double, 3> u{random.uniform(), random.uniform(), random.uniform()};
            const auto sample = bsdf.sample(wo, u, k % 2 ? Transport::radiance : Transport::importance);
            if (!sample) continue;
            sampled = true;
            if (const std::string fault = fault_of(*sample); !fault.empty())
                return refuted(cases, fault, wo, sample->wi);
            if (sample->measure == Measure::discrete) continue;
            if (const std::string fault = fault_at(bsdf, wo, sample->wi); !fault.empty())
                return refuted(cases, fault, wo, sample->wi);
        }
        if (promised && !sampled)
            return refuted(
                cases,
                fmt::format("none of {} samples scatters, though pdf() is {:.3g} and eval() {}", tries,
                            bsdf.pdf(wo, *promised), printed(bsdf.eval(wo, *promised, Transport::importance))),
                wo, *promised);
        scatters |= sampled;
    }
    if (scatters) return exactly(true, cases, fmt::format("{} values are finite and not negative", cases));
    Verdict nothing;
    nothing.samples = cases;
    nothing.reason = "nothing scatters at any direction: nothing was shown";
    return nothing;
}

}  // namespace plumb::checks
