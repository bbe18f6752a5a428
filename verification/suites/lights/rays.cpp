// Rays that lights send: their densities are 1/Jacobian of origin and direction and are known again from the ray,
// their weights are radiance over density, on average the power, and they light a receiver as light samples do.

#include "estimators/densities/warps.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"
#include "verification/suites/lights/jacobian.h"
#include "verification/suites/lights/light_subjects.h"

namespace plumb::suites {
namespace {

Point<2> two(RandomStream& random) {
    const double u = random.uniform();
    return {u, random.uniform()};
}

/// A ball around what the light shines on; not centred, so that a misplaced disk shows.
Ball scene_of(const Light& light) {
    return {{0.1, -0.2, 0.1}, light.enclosing};
}

using Change = std::function<void(EmittedRay&)>;

/// The light whose rays have a defect.
Light with_rays(const Light& light, const Change& change) {
    Light other = light;
    other.sample_ray = [right = light.sample_ray, change](const Ball& scene, const Point<2>& u, const Point<2>& v) {
        EmittedRay ray = right(scene, u, v);
        change(ray);
        return ray;
    };
    return other;
}

Verdict origin_is_jacobian(const Light& light) {
    return pdf_is_jacobian([&](const Point<2>& u) -> std::optional<Mapped> {
        const EmittedRay ray = light.sample_ray(scene_of(light), u, {0.3, 0.6});
        return Mapped{ray.origin, ray.pdf.area};
    });
}

Verdict direction_is_jacobian(const Light& light) {
    return pdf_is_jacobian([&](const Point<2>& v) -> std::optional<Mapped> {
        const EmittedRay ray = light.sample_ray(scene_of(light), {0.3, 0.6}, v);
        return Mapped{ray.direction, ray.pdf.direction};
    });
}

/// The radiance along the ray in the second lane, times the cosine at the light.
double radiance_along(const Light& light, const EmittedRay& ray) {
    if (!light.hits) return 2;
    const double cos = ray.surface ? dot(ray.surface->normal, ray.direction) : 1;
    const auto seen = light.hit(ray.origin + 1e-3 * ray.direction, -ray.direction);
    return seen ? seen->radiance[1] * cos : 0;
}

Verdict pdf_and_weight_agree(const Light& light) {
    std::vector<BoundedCase> cases;
    const Ball scene = scene_of(light);
    for (int i = 0; i < 400; ++i) {
        const Point<2> u{(i / 20 + 0.43) / 20, (i % 20 + 0.57) / 20};
        const EmittedRay ray =
            light.sample_ray(scene, u, {std::fmod(0.05 + 0.7548776662 * i, 1), std::fmod(0.013 + 0.5698402910 * i, 1)});
        const EmittedRayPdf pdf = light.ray_pdf(scene, ray.surface ? ray.surface->normal : Vec3{}, ray.direction);
        const double weight = ray.weight[1] * ray.pdf.area * ray.pdf.direction / radiance_along(light, ray);
        cases.push_back({fmt::format("u = ({}, {})", u[0], u[1]),
                         std::max({std::abs(pdf.area / ray.pdf.area - 1),
                                   std::abs(pdf.direction / ray.pdf.direction - 1), std::abs(weight - 1)}),
                         u[0]});
    }
    return within_bound(cases, 1e-9, "relative");
}

Verdict flux_is_power(const Light& light, const Run& run) {
    const Ball scene = scene_of(light);
    const auto draw = [&](RandomStream& random) {
        const Point<2> u = two(random);
        return light.sample_ray(scene, u, two(random)).weight[1];
    };
    const bool even = light.name != "environment-map";
    return mean_is(draw,
                   {.reference = light.reference_power,
                    .delta = 0.01 * light.reference_power,
                    .epsilon = 1e-12 * light.reference_power,
                    .bounds = {0, even ? HUGE_VAL : light.largest_flux},
                    .zero_variance = even},
                   run);
}

/// The light that rays carry through the unit square at z = 0, from above, less what light samples say.
Verdict rays_arrive(const Light& light, const Run& run) {
    const Ball scene = scene_of(light);
    const auto draw = [&](RandomStream& random) {
        const Point<2> u = two(random);
        const EmittedRay ray = light.sample_ray(scene, u, two(random));
        const Vec3 met = ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
        const bool through = ray.origin.z > 0 && ray.direction.z < 0 && std::abs(met.x) < 0.5 && std::abs(met.y) < 0.5;
        const Vec3 from{random.uniform() - 0.5, random.uniform() - 0.5, 0};
        const auto sample = light.sample(from, two(random));
        const double irradiance = sample ? sample->radiance[1] * std::max(0.0, sample->direction.z) / sample->pdf : 0;
        return (through ? ray.weight[1] : 0) - irradiance;
    };
    return mean_is(draw,
                   {.delta = 0.005 * light.reference_power,
                    .epsilon = 1e-12,
                    .min_samples = 8192,
                    .why_fewer = "the rarest rays arrive once in 250"},
                   run);
}

void add_one(Catalogue& catalogue, const Light& light) {
    const std::string id = "light/" + light.name, source = "ours, scenes/emitters/light.h";
    const Light twice_the_area = with_rays(light, [](EmittedRay& ray) { ray.pdf.area /= 2; });
    const Light uniform = with_rays(light, [](EmittedRay& ray) { ray.pdf.direction = 1 / (2 * pi); });
    if (light.hits)
        catalogue.add(
            {.id = id + "/ray-origin",
             .statement = "The density of origins of rays of " + light.title + " is 1/|∂p/∂u|.",
             .source = source,
             .kind = Kind::bounded,
             .trial = {
                 origin_is_jacobian, light, {{"twice-the-area", "The density of twice the area.", twice_the_area}}}});
    catalogue.add(
        {.id = id + "/ray-direction",
         .statement = "The density of directions of rays of " + light.title + " is 1/|∂ω/∂v|.",
         .source = source,
         .kind = Kind::bounded,
         .trial = {direction_is_jacobian, light, {{"uniform", "The density of a uniform hemisphere.", uniform}}}});
    catalogue.add({.id = id + "/ray-pdf",
                   .statement = "The densities of a ray of " + light.title +
                                " are found again from the ray; times its weight they are radiance and cosine.",
                   .source = source,
                   .kind = Kind::bounded,
                   .trial = {pdf_and_weight_agree,
                             light,
                             {{"twice-the-area", "The density of twice the area.", twice_the_area},
                              {"uniform", "The density of a uniform hemisphere.", uniform}}}});
    catalogue.add({.id = id + "/ray-flux",
                   .statement = "The weights of rays of " + light.title + " are its power on average.",
                   .source = source,
                   .kind = Kind::mean,
                   .trial = {flux_is_power,
                             light,
                             {{"slightly-bright", "Rays weigh 3 % more.",
                               with_rays(light, [](EmittedRay& ray) { ray.weight *= 1.03; })}}}});
    catalogue.add(
        {.id = id + "/ray-arrival",
         .statement = "Rays of " + light.title + " bring as much light to a square as samples from there say.",
         .source = source,
         .kind = Kind::mean,
         .trial = {
             rays_arrive,
             light,
             {{"upwards", "Rays leave upwards alone.",
               with_rays(light, [](EmittedRay& ray) { ray.direction.z = std::abs(ray.direction.z); })},
              {"twice", "Every ray counts twice.", with_rays(light, [](EmittedRay& ray) { ray.weight *= 2; })}}}});
}

}  // namespace

void add_lights_rays(Catalogue& catalogue) {
    for (const Light& light : lights()) add_one(catalogue, light);
}

}  // namespace plumb::suites
