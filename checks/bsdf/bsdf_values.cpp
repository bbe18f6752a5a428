#include <cmath>

#include "checks/bsdf/arithmetic.h"
#include "checks/bsdf/check_bsdf.h"
#include "checks/bsdf/directions.h"
#include "checks/bsdf/sphere_integral.h"
#include "estimators/densities/warps.h"
#include "verification/evidence/deterministic.h"

namespace plumb::checks {
namespace {

// Per steradian: less than this over the whole sphere is a 1e-8 of the light, which no sample meets.
constexpr double negligible = 1e-9;

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

/// What is wrong with the numbers that eval() and pdf() give for these directions; empty where nothing is.
std::string bad_number(const BsdfSubject& bsdf, Vec3 wo, Vec3 wi) {
    if (const double pdf = bsdf.pdf(wo, wi); !is_density(pdf)) return fmt::format("pdf() is {:.6g}", pdf);
    for (const Transport transport : {Transport::importance, Transport::radiance})
        if (const Spectrum value = bsdf.eval(wo, wi, transport); !is_spectrum(value))
            return fmt::format("eval() is {}", printed(value));
    return {};
}

/// The same, and what no sample would find.
std::string fault_at(const BsdfSubject& bsdf, Vec3 wo, Vec3 wi) {
    if (std::string bad = bad_number(bsdf, wo, wi); !bad.empty() || bsdf.pdf(wo, wi) > 0) return bad;
    for (const Transport transport : {Transport::importance, Transport::radiance})
        if (const Spectrum value = bsdf.eval(wo, wi, transport); largest(value) > negligible)
            return fmt::format("eval() is {} where pdf() is 0, so that no sample finds it", printed(value));
    return {};
}

std::string fault_of(const BsdfSample& sample, double epsilon) {
    const bool discrete = sample.measure == Measure::discrete;
    if (!(std::abs(length(sample.wi) - 1) < resolution(1e-9, epsilon)))
        return fmt::format("sample() gives the direction {} of length {:.12g}", printed(sample.wi), length(sample.wi));
    if (!(is_density(sample.pdf) && sample.pdf > 0 && !(discrete && sample.pdf > 1 + resolution(1e-9, epsilon))))
        return fmt::format("sample() gives the {} {:.6g}", discrete ? "probability" : "pdf", sample.pdf);
    if (!is_spectrum(sample.weight)) return fmt::format("sample() gives the weight {}", printed(sample.weight));
    if (!(sample.eta > 0 && std::isfinite(sample.eta))) return fmt::format("sample() gives the eta {}", sample.eta);
    return {};
}

struct Fault {
    std::string text;
    Vec3 wo, wi;
};

/// The first fault at wo and a random wi, at a random sample, and at the directions where formulas divide by zero.
std::optional<Fault> fault_from(const BsdfSubject& bsdf, Vec3 wo, RandomStream& random, double epsilon,
                                Transport transport) {
    const Vec3 far = representable(sample_uniform_sphere({random.uniform(), random.uniform()}), epsilon);
    if (std::string fault = fault_at(bsdf, wo, far); !fault.empty()) return Fault{fault, wo, far};
    const Vec3 level = representable(normalize({far.x, far.y, 0}), epsilon);
    for (const Vec3 wi : {wo, -wo, mirrored(wo), -mirrored(wo), level, Vec3{0, 0, 1}, Vec3{0, 0, -1}})
        if (std::string fault = bad_number(bsdf, wo, wi); !fault.empty()) return Fault{fault, wo, wi};
    const auto sample = bsdf.sample(wo, uniforms(random, epsilon), transport);
    if (!sample) return {};
    if (std::string fault = fault_of(*sample, epsilon); !fault.empty()) return Fault{fault, wo, sample->wi};
    if (sample->measure == Measure::discrete) return {};
    if (std::string fault = fault_at(bsdf, wo, sample->wi); !fault.empty()) return Fault{fault, wo, sample->wi};
    return {};
}

/// Directions of any kind, and every eighth along the normal or within the surface.
Vec3 direction_of_values(RandomStream& random, std::uint64_t index, double epsilon) {
    const Vec3 wo = any_direction(random);
    if (index % 16 == 0) return {0, 0, std::copysign(1.0, wo.z)};
    if (index % 16 == 8) return representable(normalize({wo.x, wo.y, 0}), epsilon);
    return representable(wo, epsilon);
}

constexpr int tries = 256;

struct Scattering {
    bool scatters = false;
    std::string fault;
};

/// Whether samples scatter from wo, and whether they should: where a tenth of the light does, 256 samples all miss it
/// with a probability of 2e-12.
Scattering scattering(const BsdfSubject& bsdf, Vec3 wo, RandomStream& random, double epsilon) {
    for (int i = 0; i < tries; ++i)
        if (bsdf.sample(wo, uniforms(random, epsilon), i % 2 ? Transport::radiance : Transport::importance))
            return {true, {}};
    const SphereIntegral mass(
        wo, [&](Vec3 wi) { return bsdf.pdf(wo, wi); }, std::array{mirrored(wo), wo, -wo, -mirrored(wo)}, 40'000);
    if (!(mass.total() - mass.error() > 0.1)) return {};
    return {false, fmt::format("none of {} samples scatters, though pdf() integrates to {:.4g}", tries, mass.total())};
}

}  // namespace

Verdict values_are_sound(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    constexpr std::uint64_t cases = 6400;
    const double epsilon = epsilon_of(bsdf, traits, run);
    const auto refuted = [](std::uint64_t tried, const Fault& fault) {
        const bool of_wo = length_squared(fault.wi) == 0;
        return exactly(
            false, tried,
            fmt::format("{} ({})", fault.text, of_wo ? "wo " + name_of(fault.wo) : in_words(fault.wo, fault.wi)));
    };
    for (std::uint64_t i = 0; i < cases; ++i) {
        RandomStream random = run.random(i);
        const Vec3 wo = direction_of_values(random, i, epsilon);
        const double discrete = bsdf.discrete ? bsdf.discrete(wo) : 0;
        if (!(discrete >= 0 && discrete <= 1 + resolution(1e-9, epsilon)))
            return refuted(i, {fmt::format("discrete() is {:.6g}", discrete), wo, {}});
        const Transport transport = i % 2 ? Transport::radiance : Transport::importance;
        if (const auto fault = fault_from(bsdf, wo, random, epsilon, transport)) return refuted(i, *fault);
    }
    bool scatters = false;
    const std::vector<Vec3> directions = check_directions(run);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        RandomStream random = run.random(cases + i);
        const Vec3 wo = representable(directions[i], epsilon);
        const Scattering found = scattering(bsdf, wo, random, epsilon);
        if (!found.fault.empty()) return refuted(cases, {found.fault, wo, {}});
        scatters |= found.scatters;
    }
    if (scatters) return exactly(true, cases, fmt::format("{} values are finite and not negative", cases));
    Verdict nothing;
    nothing.samples = cases;
    nothing.reason = "nothing scatters at any direction: nothing was shown";
    return nothing;
}

}  // namespace plumb::checks
