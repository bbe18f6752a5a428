// Samples of lights, of BSDFs, and of both find the same light where no closed form is known: glossy, textured and
// masked surfaces, several lights, environments.

#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"
#include "verification/suites/direct/direct_subjects.h"

namespace plumb::suites {
namespace {

using Estimator = std::shared_ptr<const PathEstimator>;

/// A room corner with a glossy chequered floor, a wall, a rough metal ball, a lace before one of three lights, a sky.
description::Scene studio() {
    description::Scene scene;
    const auto chequered = [&](double a, double b, double scale) {
        scene.textures.push_back({description::Checkerboard{Spectrum::rgb(a, 0.6 * a, a), Spectrum::grey(b)},
                                  Transform::scale({scale, scale, 1}),
                                  {}});
        return description::TextureId{static_cast<std::uint32_t>(scene.textures.size() - 1)};
    };
    using description::Microfacets;
    const auto floor = add_material(scene, description::Plastic{1.5, chequered(0.8, 0.2, 4), Spectrum::grey(1), true,
                                                                description::Roughness{Microfacets::ggx, 0.2}});
    const auto wall = add_material(scene, description::Diffuse{Spectrum::rgb(0.7, 0.5, 0.3)});
    const auto metal = add_material(
        scene, description::Conductor{Spectrum::rgb(0.2, 0.9, 1.1), Spectrum::rgb(3.9, 2.4, 2.2), Spectrum::grey(1),
                                      description::Roughness{Microfacets::beckmann, 0.3}});
    const auto black = add_material(scene, description::Diffuse{Spectrum{}});
    const auto lace = add_material(scene, description::Mask{chequered(0.9, 0.2, 6), wall});
    add_polygon(scene, {{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}, floor);
    add_polygon(scene, {{-3, 2, 0}, {3, 2, 0}, {3, 2, 4}, {-3, 2, 4}}, wall);
    add_shape(scene, description::Sphere{{0.6, 0.7, 0.6}, 0.6, false, {}}, metal);
    add_polygon(scene, {{-2, -1, 2.5}, {-2, 1, 2.5}, {0, 1, 2.5}, {0, -1, 2.5}}, black, Spectrum::rgb(3, 2.5, 2));
    add_polygon(scene, {{-1.5, -1, 1.9}, {-1.5, 1, 1.9}, {0, 1, 1.9}, {0, -1, 1.9}}, lace);
    add_shape(scene, description::Sphere{{1.6, -0.4, 1.7}, 0.6, false, {}}, black, Spectrum::rgb(2, 2, 4));
    scene.emitters.push_back({description::ConstantSky{Spectrum::rgb(0.2, 0.3, 0.5)}, {}});
    scene.sensor = camera({0, -4, 2.2}, {0, 0.8, 0.6}, 50, 8, 6);
    scene.sensor->to_world = Transform::look_at({0, -4, 2.2}, {0, 0.8, 0.6}, {0, 0, 1});
    return scene;
}

description::Scene shipped(const std::string& name) {
    return load_mitsuba(scene_file(name));
}

struct View {
    std::string id, title;
    description::Scene (*scene)();
    std::optional<Point<2>> film;
    FilmRegion region;
    TechniqueCounts against;  ///< what is compared with both techniques, weighted
    double delta;             ///< relative to the mean
    std::uint32_t n;
};

const std::vector<View>& views() {
    static const std::vector<View> list{
        {"studio-emitters",
         "the floor of a studio with three lights, a lace and a sky",
         studio,
         Point<2>{3.5, 4.5},
         {},
         lights_alone,
         0.02,
         64},
        {"studio-bsdf",
         "all of a studio with three lights, a lace and a sky",
         studio,
         {},
         {0, 0, 8, 6},
         bsdf_alone,
         0.03,
         64},
        {"sky-emitters",
         "tiles under the sky of the scene glass",
         [] { return shipped("glass"); },
         Point<2>{60.5, 150.5},
         {},
         lights_alone,
         0.02,
         64},
        {"sky-bsdf",
         "tiles under the sky of the scene glass",
         [] { return shipped("glass"); },
         Point<2>{60.5, 150.5},
         {},
         bsdf_alone,
         0.02,
         64},
        {"plates-emitters",
         "a rough one of Veach's plates",
         [] { return shipped("veach_plates"); },
         Point<2>{150.5, 150.5},
         {},
         lights_alone,
         0.02,
         64},
        {"plates-bsdf",
         "a smooth one of Veach's plates, where it reflects a light",
         [] { return shipped("veach_plates"); },
         Point<2>{75.5, 122.5},
         {},
         bsdf_alone,
         0.04,
         64},
    };
    return list;
}

Verdict agree(const View& view, const PathEstimator& mis, const Run& run) {
    const Scene scene(view.scene());
    const Direct single(view.against);
    const Measurement weighted{scene, mis, view.film, view.region, view.n};
    const Measurement alone{scene, single, view.film, view.region, view.n};
    double pilot = 0;
    const Run of_pilot = run.part("pilot");
    const Direct right;
    const Measurement typical{scene, right, view.film, view.region, view.n};
    for (std::uint64_t i = 0; i < 64; ++i) {
        RandomStream random = of_pilot.random(i);
        pilot += luminance(typical.draw(random)) / 64;
    }
    const auto draw = [&](RandomStream& random) {
        RandomStream same = random;
        return luminance(weighted.draw(random)) - luminance(alone.draw(same));
    };
    return mean_is(draw,
                   {.reference = 0,
                    .delta = run.pick(1.0, 0.25) * view.delta * pilot,
                    .why_fewer = "every light is met by some of a draw's paths"},
                   run);
}

// ---- mutants

NextEvent without_pmf() {
    return with_changed_lights([](SceneLightSample& light, const SurfacePoint&) { light.pdf = light.sample.pdf; });
}

/// The density of a direction that met nothing, without the environment's probability among the lights.
double environment_alone(const Scene& scene, Vec3 from, Vec3 direction) {
    for (const Light& light : scene.lights())
        if (is_environment(light)) return std::visit([&](const auto& l) { return l.hit(from, direction)->pdf; }, light);
    return 0;
}

/// gather_from_bsdf with another density for the environment.
Spectrum from_bsdf_without_pmf(const Scene& scene, const PathVertex& vertex, const Draws& of_vertex,
                               PathRecord& record) {
    Draws draws = of_vertex.branch();
    const auto u = draws.at({1, Use::direction});
    const auto sample =
        vertex.bsdf.sample(vertex.to_local(vertex.wo), {draws.at({1, Use::lobe})[0], u[0], u[1]}, Transport::radiance);
    if (!sample) return {};
    const Vec3 wi = vertex.frame.to_world(sample->wi), from = vertex.hit.point.position;
    if (!vertex.agree(wi)) return {};
    const Ray ray = leave(vertex.hit.point, wi);
    const auto hit = scene.intersect(ray, draws.at({2, Use::shadow})[0], record.rays);
    const Spectrum radiance = hit ? scene.emitted(*hit, -wi) : scene.environment(ray);
    const double density = hit ? scene.light_pdf(*hit, from, wi) : environment_alone(scene, from, wi);
    return sample->weight * radiance * mis_weight<Power>(std::array{density, sample->pdf}, 1);
}

std::vector<Wrong<Estimator>> wrong_for(const View& view) {
    std::vector<Wrong<Estimator>> wrong{{"slightly-bright", fmt::format("{:.3g} % too bright.", 250 * view.delta),
                                         std::make_shared<Scaled>(std::make_shared<Direct>(), 1 + 2.5 * view.delta)}};
    if (view.id.starts_with("sky"))  // elsewhere lights are small and bright: this one's tails would be heavy
        wrong.push_back(
            {"counted-twice", "Both techniques count in full.", std::make_shared<Direct>(with_weight(in_full))});
    if (view.id == "studio-emitters")
        wrong.push_back({"pmf-dropped", "The probability of the light is missing in the density of its samples.",
                         std::make_shared<Direct>(without_pmf())});
    return wrong;
}

// ---- an environment among other lights

/// A white point under a white sky is white; one light in two chosen shines elsewhere.
Verdict is_white(const PathEstimator& estimator, const Run& run) {
    description::Scene description;
    const auto white = add_material(description);
    add_receiver(description, {}, {0, 0, 1}, white);
    add_polygon(description, {{-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}}, white, Spectrum::grey(1));
    // Flux into the scene's ball against that of 4 units of area behind the receiver that look away.
    const double radius = ball_around(description.shapes).radius, sky = pi * pi * radius * radius, rectangle = 4 * pi;
    description.shapes.back().emitter->radiance = Spectrum::grey(sky / rectangle);
    description.emitters.push_back({description::ConstantSky{Spectrum::grey(1)}, {}});
    description.sensor = camera({0, 0, 0.1}, {});
    const Scene scene(std::move(description));
    const Measurement measurement{.scene = scene, .estimator = estimator, .film = Point<2>{0.5, 0.5}, .n = 32};
    return mean_is([&](RandomStream& random) { return measurement.draw(random)[0]; },
                   {.reference = 1,
                    .delta = run.pick(0.01, 0.0025),
                    .epsilon = 1e-9,
                    .why_fewer = "one light in two, 32 paths a draw"},
                   run);
}

void add_environment(Catalogue& catalogue) {
    const auto check = [](const Estimator& estimator, const Run& run) { return is_white(*estimator, run); };
    const auto one_side = [](const Scene& scene, const PathVertex& vertex, const Draws& draws, PathRecord& record) {
        return gather_from_lights(scene, vertex, 1, {}, draws, record) +
               from_bsdf_without_pmf(scene, vertex, draws, record);
    };
    catalogue.add(
        {.id = "direct/environment/mis",
         .statement = "A white point under a white sky, one of two lights, is white by both techniques, weighted.",
         .source = "[Veach & Guibas 1995]",
         .kind = Kind::mean,
         .trial = {
             check,
             std::make_shared<Direct>(),
             {{"pmf-dropped", "The probability of the light is missing in the density of its samples.",
               std::make_shared<Direct>(without_pmf())},
              {"environment-pmf-dropped",
               "In the BSDF's weight the environment's probability among the lights is missing.",
               std::make_shared<DirectBy>(one_side)},
              {"slightly-bright", "2.5 % too bright.", std::make_shared<Scaled>(std::make_shared<Direct>(), 1.025)}}}});
}

}  // namespace

void add_direct_techniques(Catalogue& catalogue) {
    for (const View& view : views())
        catalogue.add(
            {.id = "direct/techniques/" + view.id,
             .statement = fmt::format("Samples of {} and both techniques, weighted, find the same light on {}.",
                                      view.against == bsdf_alone ? "the BSDF" : "lights", view.title),
             .source = "[Veach & Guibas 1995]",
             .kind = Kind::mean,
             .trial = {[=](const Estimator& estimator, const Run& run) { return agree(view, *estimator, run); },
                       std::make_shared<Direct>(), wrong_for(view)}});
    add_environment(catalogue);
}

}  // namespace plumb::suites
