// Lights one by one: the density of a sample is 1/Jacobian of its direction, a ray that meets the light tells the
// same story as the sample, the density integrates to 1 over all directions, the flux through a closed surface is the
// power.

#include "estimators/densities/warps.h"
#include "verification/claim.h"
#include "verification/evidence/distribution.h"
#include "verification/evidence/mean.h"
#include "verification/suites/lights/jacobian.h"
#include "verification/suites/lights/light_subjects.h"

namespace plumb::suites {
namespace {

Point<2> two(RandomStream& random) {
    const double u = random.uniform();
    return {u, random.uniform()};
}

Verdict density_is_jacobian(const Light& light) {
    return pdf_is_jacobian([&](const Point<2>& u) -> std::optional<Mapped> {
        const auto sample = light.sample({}, u);
        if (!sample) return {};
        return Mapped{sample->direction, sample->pdf};
    });
}

Verdict hit_agrees(const Light& light) {
    std::vector<BoundedCase> cases;
    for (int i = 0; i < 400; ++i) {
        const Point<2> u{(i / 20 + 0.43) / 20, (i % 20 + 0.57) / 20};
        const auto sample = light.sample({}, u);
        if (!sample) continue;
        const auto hit = light.hit({}, sample->direction);
        const double distance = std::isinf(sample->distance) && hit && std::isinf(hit->distance)
                                    ? 0
                                    : (hit ? hit->distance / sample->distance - 1 : HUGE_VAL);
        const double pdf = hit ? hit->pdf / sample->pdf - 1 : HUGE_VAL;
        const double radiance = hit ? hit->radiance[1] - sample->radiance[1] : HUGE_VAL;
        cases.push_back({fmt::format("u = ({}, {})", u[0], u[1]),
                         std::max({std::abs(distance), std::abs(pdf), std::abs(radiance)}), u[0]});
    }
    return within_bound(cases, 1e-10, "relative");
}

Verdict mass_is_one(const Light& light, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        const auto hit = light.hit({}, sample_uniform_sphere(two(random)));
        return hit ? 4 * pi * hit->pdf : 0;
    };
    return mean_is(draw,
                   {.reference = 1,
                    .delta = 0.02,
                    .epsilon = 1e-12,
                    .bounds = {0, 4 * pi * light.largest_pdf},
                    .zero_variance = light.uniform},
                   run);
}

/// The flux through a sphere around the light or, for environments, into it is the light's power: ∫ ∫ L cos θ dω dA.
Verdict flux_is_power(const Light& light, const Run& run) {
    const double area = 4 * pi * light.enclosing * light.enclosing, power = light.power(light.enclosing)[1];
    const double side = light.infinite ? 1 : -1;  // on which side of the sphere it is
    const auto draw = [&](RandomStream& random) {
        const Vec3 out = sample_uniform_sphere(two(random));
        const auto sample = light.sample(light.centre + light.enclosing * out, two(random));
        return sample ? area * sample->radiance[1] * std::max(0.0, side * dot(out, sample->direction)) / sample->pdf
                      : 0;
    };
    return mean_is(draw,
                   {.reference = light.reference_power,
                    .delta = 0.01 * light.reference_power,
                    .epsilon = 1e-12 * power,
                    .bounds = {0, light.largest_flux}},
                   run);
}

Verdict power_is(const Light& light, double found) {
    return within_bound({{light.name, std::abs(found / light.reference_power - 1)}}, 1e-12, "relative");
}

Light hit_with_wrong_pdf(const Light& light) {
    Light other = light;
    other.hit = light.with_wrong_pdf().hit;
    return other;
}

Light with_larger_pdf(const Light& light) {
    Light other = light;
    other.largest_pdf *= 1.05;
    other.hit = [light](Vec3 from, Vec3 direction) {
        auto hit = light.hit(from, direction);
        if (hit) hit->pdf *= 1.05;
        return hit;
    };
    return other;
}

void add_one(Catalogue& catalogue, const Light& light) {
    const std::string id = "light/" + light.name;
    if (light.hits) {
        catalogue.add(
            {.id = id + "/jacobian",
             .statement = "The density of samples of " + light.title + " is 1/|∂ω/∂u|.",
             .source = light.source,
             .kind = Kind::bounded,
             .trial = {density_is_jacobian, light, {{"another-pdf", light.pdf_defect, light.with_wrong_pdf()}}}});
        catalogue.add({.id = id + "/hit",
                       .statement = "A ray towards a sample of " + light.title +
                                    " meets it with the sample's density, radiance and distance.",
                       .source = light.source,
                       .kind = Kind::bounded,
                       .trial = {hit_agrees, light, {{"another-pdf", light.pdf_defect, hit_with_wrong_pdf(light)}}}});
        catalogue.add({.id = id + "/mass",
                       .statement = "The density of " + light.title + " integrates to 1 over all directions.",
                       .source = light.source,
                       .kind = Kind::mean,
                       .trial = {mass_is_one,
                                 light,
                                 {{"another-pdf", light.pdf_defect, light.with_wrong_pdf()},
                                  {"slightly-large", "The density is 5 % too large.", with_larger_pdf(light)}}}});
    }
    catalogue.add({.id = id + "/power",
                   .statement = "The power of " + light.title + " is what its radiance and area give.",
                   .source = light.source,
                   .kind = Kind::bounded,
                   .trial = {[light](double found) { return power_is(light, found); },
                             light.power(light.enclosing)[1],
                             {{"without-pi", "π is missing.", light.power(light.enclosing)[1] / pi}}}});
    catalogue.add({.id = id + "/flux",
                   .statement = "The flux of " + light.title + " through a sphere, by light samples, is its power.",
                   .source = "ours, verification/suites/lights/lights.cpp",
                   .kind = Kind::mean,
                   .trial = {flux_is_power, light, {{"another-sample", light.pdf_defect, light.with_wrong_pdf()}}}});
}

/// The four rows and eight columns of the shipped environment map; a pixel's mass is its density times its solid angle.
std::size_t environment_cell(Vec3 direction) {
    const Point<2> uv = environment_map().place_of(direction);
    return equal_cell(uv[0], 8) + 8 * equal_cell(uv[1], 4);
}

Verdict environment_samples_follow(const std::function<Vec3(const Point<2>&)>& sample, const Run& run) {
    DistributionClaim claim{{}, 0.05};
    for (int cell = 0; cell < 32; ++cell) {
        const double phi = 2 * pi * (cell % 8 + 0.5) / 8, top = pi * (cell / 8) / 4, theta = top + pi / 8;
        const Vec3 middle{std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
        const double solid_angle = 2 * pi / 8 * (std::cos(top) - std::cos(top + pi / 4));
        claim.probabilities.push_back(environment_map().hit({}, environment_frame().to_world(middle))->pdf *
                                      solid_angle);
    }
    return distribution_is([&](RandomStream& random) { return environment_cell(sample(two(random))); }, claim, run);
}

void add_environment_distribution(Catalogue& catalogue) {
    const auto right = [](const Point<2>& u) { return environment_map().sample({}, u)->direction; };
    catalogue.add(
        {.id = "light/environment-map/distribution",
         .statement = "Samples of an environment map fall into its pixels with their densities times solid angles.",
         .source = "ours, scenes/emitters/environment_map.h",
         .kind = Kind::distribution,
         .trial = {environment_samples_follow,
                   right,
                   {{"uniform", "Directions are uniform.", sample_uniform_sphere},
                    {"distorted", "The number that chooses rows is raised to 1.15.", [right](const Point<2>& u) {
                         return right({u[0], std::pow(u[1], 1.15)});
                     }}}}});
}

}  // namespace

void add_lights_lights(Catalogue& catalogue) {
    for (const Light& light : lights()) add_one(catalogue, light);
    add_environment_distribution(catalogue);
}

}  // namespace plumb::suites
