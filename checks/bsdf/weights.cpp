#include <cmath>

#include "checks/bsdf/arithmetic.h"
#include "checks/bsdf/cases.h"
#include "checks/bsdf/check_bsdf.h"
#include "checks/bsdf/directions.h"
#include "checks/bsdf/factors.h"
#include "checks/bsdf/lobes.h"

namespace plumb::checks {
namespace {

constexpr std::size_t batches = 64, samples_of_batch = 64, scans_of_batch = 4;

// eval() for importance, by its largest lane.
double value_of(const BsdfSubject& bsdf, Vec3 wo, Vec3 wi) {
    return largest(bsdf.eval(wo, wi, Transport::importance));
}

void add_smooth(std::vector<Case>& cases, const BsdfSubject& bsdf, Vec3 wo, const BsdfSample& sample,
                Transport transport, double epsilon) {
    const double density = bsdf.pdf(wo, sample.wi), bound = resolution(1e-7, epsilon);
    Case pdf = equal("the pdf of sample() for pdf()", wo, sample.wi, sample.pdf, density);
    pdf.cause = "pdf() holds if multiplied by {}";
    Case weight =
        equal("weight · pdf() for eval()", wo, sample.wi, sample.weight * density, bsdf.eval(wo, sample.wi, transport));
    weight.cause = "holds if eval() is multiplied by {}";
    if (std::max(pdf.error, weight.error) > bound) {
        pdf.known = rounding_of(bsdf.pdf, wo, sample.wi, epsilon);
        weight.known =
            pdf.known + rounding_of([&](Vec3 o, Vec3 i) { return value_of(bsdf, o, i); }, wo, sample.wi, epsilon);
    }
    cases.push_back(pdf);
    cases.push_back(weight);
}

// A mirror's direction given, u[1] and u[2] change nothing.
void add_mirror(std::vector<Case>& cases, Vec3 wo, const BsdfSample& sample, const std::optional<BsdfSample>& twin) {
    if (!same_outcome(sample, twin)) return;
    cases.push_back(equal("a mirror's probability for that at another u[1]", wo, sample.wi, sample.pdf, twin->pdf));
    cases.push_back(equal("a mirror's weight for that at another u[1]", wo, sample.wi, sample.weight, twin->weight));
}

void add_shares(std::vector<Case>& cases, const BsdfSubject& bsdf, Vec3 wo, RandomStream& random, double epsilon) {
    const std::array<double, 3> u = uniforms(random, epsilon);
    double discrete = 0;
    for (const Lobe& lobe : lobes(bsdf, wo, {u[1], u[2]}, Transport::importance, u[0]))
        if (lobe.discrete()) {
            const double announced = lobe.sample->pdf;
            cases.push_back({.of = "the probability of a mirror for its share of u[0]",
                             .wo = wo,
                             .wi = lobe.sample->wi,
                             .found = announced,
                             .expected = lobe.share,
                             .error = std::abs(announced - lobe.share)});
            discrete += lobe.share;
        }
    if (!bsdf.discrete) return;
    const double stated = bsdf.discrete(wo);
    cases.push_back({.of = "discrete() for its share of u[0]",
                     .wo = wo,
                     .found = stated,
                     .expected = discrete,
                     .error = std::abs(stated - discrete)});
}

}  // namespace

Verdict weight_is_eval_over_pdf(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    const double epsilon = epsilon_of(bsdf, traits, run);
    const auto cases = gathered(batches, [&](std::size_t batch) {
        std::vector<Case> found;
        RandomStream random = run.random(batch);
        for (std::size_t k = 0; k < samples_of_batch; ++k) {
            const Transport transport = k % 2 ? Transport::radiance : Transport::importance;
            const Vec3 wo = representable(any_direction(random), epsilon);
            const std::array<double, 3> u = uniforms(random, epsilon), other = uniforms(random, epsilon);
            const std::optional<BsdfSample> sample = bsdf.sample(wo, u, transport);
            if (!sample) continue;
            if (sample->measure == Measure::solid_angle)
                add_smooth(found, bsdf, wo, *sample, transport, epsilon);
            else
                add_mirror(found, wo, *sample, bsdf.sample(wo, {u[0], other[1], other[2]}, transport));
        }
        for (std::size_t k = 0; k < scans_of_batch; ++k)
            add_shares(found, bsdf, representable(any_direction(random), epsilon), random, epsilon);
        return found;
    });
    return judged(cases, {.bound = resolution(1e-7, epsilon),
                          .unit = "relative",
                          .coarse = 0.05,
                          .nothing = "nothing scatters",
                          .factors = factors_of_values()});
}

}  // namespace plumb::checks
