#include <cmath>

#include "checks/bsdf/arithmetic.h"
#include "checks/bsdf/cases.h"
#include "checks/bsdf/check_bsdf.h"
#include "checks/bsdf/directions.h"
#include "checks/bsdf/factors.h"
#include "checks/bsdf/lobes.h"
#include "estimators/densities/warps.h"

namespace plumb::checks {
namespace {

constexpr std::size_t batches = 64, pairs_of_batch = 25, mirrors_of_batch = 4;

// f is eval()/|wi.z|. What is less than this per steradian and projected area no path meets.
constexpr double negligible = 1e-9;

double across(Vec3 wo, Vec3 wi, const BsdfTraits& traits) {
    return same_side(wo, wi) ? 1 : wo.z > 0 ? traits.eta : 1 / traits.eta;
}

void add_pair(std::vector<Case>& cases, const BsdfSubject& bsdf, const BsdfTraits& traits, Vec3 wo, Vec3 wi,
              double epsilon) {
    const auto f = [&](Vec3 from, Vec3 to, Transport t) { return bsdf.eval(from, to, t) / std::abs(to.z); };
    const Spectrum back = f(wi, wo, Transport::radiance), there = f(wo, wi, Transport::importance);
    if (std::max(largest(back), largest(there)) < negligible) return;
    const double eta = across(wo, wi, traits);
    Case adjoint = equal("f of importance for f of radiance back", wo, wi, there, back);
    Case scaled = equal("f eta² of radiance for f back", wo, wi, f(wo, wi, Transport::radiance) * (eta * eta), back);
    if (std::max(adjoint.error, scaled.error) > resolution(1e-7, epsilon)) {
        const auto value = [&](Vec3 o, Vec3 i) { return largest(f(o, i, Transport::importance)); };
        adjoint.known = scaled.known = rounding_of(value, wo, wi, epsilon) + rounding_of(value, wi, wo, epsilon);
    }
    adjoint.cause = scaled.cause = "holds if eval() is multiplied by {}";
    cases.push_back(adjoint);
    cases.push_back(scaled);
}

// The discrete sample at wi that leads to wo. Where scans of u[0] meet none, one of a probability above 0.02 is missed
// by 1024 samples once in 10^9.
std::optional<BsdfSample> way_back(const BsdfSubject& bsdf, Vec3 wo, Vec3 wi, const std::array<double, 3>& u,
                                   double within, RandomStream& random, double epsilon) {
    const auto leads_back = [&](const std::optional<BsdfSample>& s) {
        return s && s->measure == Measure::discrete && length(s->wi - wo) < within;
    };
    for (const Lobe& lobe : lobes(bsdf, wi, {u[1], u[2]}, Transport::importance, u[0]))
        if (leads_back(lobe.sample)) return lobe.sample;
    for (int i = 0; i < 1024; ++i)
        if (const auto sample = bsdf.sample(wi, uniforms(random, epsilon), Transport::importance); leads_back(sample))
            return sample;
    return {};
}

// Where the directions are as far from the surface as each other, in the measure of their sides, dωi |wi.z| eta² =
// dωo |wo.z|, and the reflectances are equal.
bool is_level(Vec3 wo, const BsdfSample& sample) {
    const double eta = sample.eta, rest = eta * eta * (1 - sample.wi.z * sample.wi.z) - (1 - wo.z * wo.z);
    return std::abs(rest) < 1e-6;
}

void add_mirror(std::vector<Case>& cases, const BsdfSubject& bsdf, Vec3 wo, const BsdfSample& there,
                const std::array<double, 3>& u, RandomStream& random, double epsilon) {
    // At the critical angle a refracted direction moves by the root of what its cosine does.
    const double within = 32 * std::sqrt(epsilon);
    const Vec3 wi = representable(there.wi, epsilon);
    const auto back = way_back(bsdf, wo, wi, u, within, random, epsilon);
    if (!back) {
        if (there.pdf > 0.05 && std::min(std::abs(wi.z), std::abs(wo.z)) > within)
            cases.push_back({.of = "ways back from a discrete direction",
                             .wo = wo,
                             .wi = wi,
                             .found = 0,
                             .expected = 1,
                             .error = 1});
        return;
    }
    if (!is_level(wo, there)) return;
    Case c = equal("a mirror's reflectance for that of the way back", wo, wi, there.weight * there.pdf,
                   back->weight * back->pdf);
    c.known = rounding_operations * epsilon * (1 + 1 / (wo.z * wo.z) + 1 / (wi.z * wi.z));
    cases.push_back(c);
}

// The normal of the interface that refracts wo to wi, times the change of index: wo + eta wi.
struct Refraction {
    Vec3 wo, wi;
    double eta;
    [[nodiscard]] Vec3 normal() const { return normalize(wo + wi * eta); }
};

// Snell's law: one normal refracts all.
std::vector<Case> of_one_normal(const std::vector<Refraction>& all, double epsilon) {
    std::vector<Case> cases;
    for (const Refraction& r : all) {
        const double off = length(cross(r.normal(), all[0].normal()));
        cases.push_back({.of = "sine between the normal that refracts this and another direction",
                         .wo = r.wo,
                         .wi = r.wi,
                         .found = off,
                         .expected = 0,
                         .error = off,
                         .known = 2 * rounding_operations * epsilon / std::abs(r.eta - 1)});
    }
    return cases;
}

}  // namespace

Verdict is_reciprocal(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    const double epsilon = epsilon_of(bsdf, traits, run);
    std::vector<std::vector<Refraction>> refractions(batches);
    auto cases = gathered(batches, [&](std::size_t batch) {
        std::vector<Case> found;
        RandomStream random = run.random(batch);
        std::size_t mirrors = 0;
        for (std::size_t k = 0; k < pairs_of_batch; ++k) {
            const Vec3 wo = representable(any_direction(random), epsilon);
            const std::array<double, 3> u = uniforms(random, epsilon), other = uniforms(random, epsilon);
            add_pair(found, bsdf, traits, wo, representable(sample_uniform_sphere({other[1], other[2]}), epsilon),
                     epsilon);
            const auto sample = bsdf.sample(wo, u, Transport::importance);
            if (!sample) continue;
            if (sample->measure == Measure::solid_angle) {
                add_pair(found, bsdf, traits, wo, sample->wi, epsilon);
                continue;
            }
            if (sample->eta != 1) refractions[batch].push_back({wo, sample->wi, sample->eta});
            if (mirrors++ < mirrors_of_batch) add_mirror(found, bsdf, wo, *sample, other, random, epsilon);
        }
        return found;
    });
    std::vector<Refraction> all;
    for (const auto& part : refractions) all.insert(all.end(), part.begin(), part.end());
    for (const Case& c : of_one_normal(all, epsilon)) cases.push_back(c);
    return judged(cases, {.bound = resolution(1e-7, epsilon),
                          .unit = "relative",
                          .coarse = 0.05,
                          .nothing = "nothing scatters",
                          .factors = factors_of_reciprocity()});
}

Verdict radiance_scales_by_eta_squared(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    const double epsilon = epsilon_of(bsdf, traits, run);
    const auto cases = gathered(batches, [&](std::size_t batch) {
        std::vector<Case> found;
        RandomStream random = run.random(batch);
        for (std::size_t k = 0; k < pairs_of_batch; ++k) {
            const Vec3 wo = representable(any_direction(random), epsilon);
            const std::array<double, 3> u = uniforms(random, epsilon);
            const auto particle = bsdf.sample(wo, u, Transport::importance);
            const auto light = bsdf.sample(wo, u, Transport::radiance);
            if (!particle && !light) continue;
            if (!particle || !light) {
                found.push_back({.of = "samples of radiance for those of importance",
                                 .wo = wo,
                                 .found = light ? 1. : 0.,
                                 .expected = particle ? 1. : 0.,
                                 .error = 1});
                continue;
            }
            const double eta = across(wo, light->wi, traits);
            found.push_back(equal("a sample's eta for that of its sides", wo, light->wi, light->eta, eta));
            // Where the strategies differ, the weights of each are compared with eval() instead.
            if (light->measure == Measure::solid_angle && !same_outcome(particle, light)) continue;
            found.push_back(equal("weight · eta² of radiance for that of importance", wo, light->wi,
                                  light->weight * (eta * eta), particle->weight));
            found.back().cause = "radiance lacks a factor of {} in its inverse";
        }
        return found;
    });
    return judged(
        cases,
        {.bound = resolution(1e-14, epsilon), .unit = "relative", .coarse = 0.05, .nothing = "nothing scatters"});
}

}  // namespace plumb::checks
