// Shadow rays of the renderer: an end that lies on a light does not hide the light, and masks let through their share.

#include "scenes/geometry/surface_point.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"
#include "verification/suites/direct/direct_subjects.h"

namespace plumb::suites {
namespace {

const Spectrum white = Spectrum::grey(1);

// ---- ends on lights

/// A floor around `at`, walled by a light of this kind, or lit by it from above; nothing in between.
description::Scene open_scene(const std::string& kind, Vec3 at) {
    description::Scene scene;
    const auto grey = add_material(scene);
    add_receiver(scene, at, {0, 0, 1}, grey, 2);
    if (kind == "rectangle")
        add_polygon(scene,
                    {at + Vec3{-1, 0.5, 0}, at + Vec3{1, 0.5, 0}, at + Vec3{1, 0.5, 1.5}, at + Vec3{-1, 0.5, 1.5}},
                    grey, white);
    if (kind == "mesh")
        add_polygon(scene,
                    {at + Vec3{-1, -0.5, 1.1}, at + Vec3{0, 0.7, 1.3}, at + Vec3{1, 0.5, 1.2}, at + Vec3{1, -0.3, 1},
                     at + Vec3{0.1, -0.6, 1}},
                    grey, white);
    if (kind == "sphere") add_shape(scene, description::Sphere{at + Vec3{0.3, 0.2, 1}, 0.5, false, {}}, grey, white);
    if (kind == "disk")
        add_shape(scene, description::Disk{at + Vec3{0, 0.5, 1.3}, {0, 0.6, -0.8}, {-1, 0, 0}, {0, -0.8, -0.6}}, grey,
                  white);
    return scene;
}

using End = std::function<SurfacePoint(const SurfacePoint&)>;

Verdict light_is_seen(const std::string& kind, const End& end, const Run& run) {
    std::uint64_t count = 0, hidden = 0;
    RayLog rays;
    for (int exponent = -1; exponent <= 12; ++exponent) {
        RandomStream random = run.random(static_cast<std::uint64_t>(exponent + 1));
        const Vec3 at = exponent < 0 ? Vec3{} : std::exp2(exponent) * normalize(Vec3{1, -0.7, 0.4});
        const Scene scene(open_scene(kind, at));
        const Vec3 start = at + Vec3{0, 0, 0.5};
        for (int i = 0; i < run.pick(1000, 50'000); ++i) {
            const auto hit = scene.intersect(
                rounded_ray(start, {random.uniform() - 0.5, 0.9 * random.uniform() - 0.45, -0.5}), 0, rays);
            if (!hit || hit->shape != 0) continue;
            const double u = random.uniform();
            auto light = scene.sample_light(hit->point.position, 0, {u, random.uniform()});
            // Far out, floats turn planes: from places that no longer see the light's front, nothing is asked.
            if (!light || dot(light->sample.direction, hit->point.normal) < 0.01 ||
                -dot(light->sample.direction, light->sample.surface->normal) < 0.01)
                continue;
            light->sample.surface = end(*light->sample.surface);
            ++count;
            hidden += scene.transmittance(hit->point, light->sample, rays) == 0;
        }
    }
    return exactly(hidden == 0 && count > 1000, count,
                   fmt::format("{} of {} samples of the light are hidden", hidden, count));
}

/// What a light whose rays meet triangles must not do.
SurfacePoint end_in_double(const SurfacePoint& point) {
    return disk_point(point.position, point.normal, 1);
}
SurfacePoint end_behind(const SurfacePoint& point) {
    SurfacePoint end = point;
    end.margin = -4 * dot({std::abs(point.normal.x), std::abs(point.normal.y), std::abs(point.normal.z)},
                          float_rounding(2 * point.position)) -
                 1e-6;
    return end;
}

void add_ends(Catalogue& catalogue) {
    for (const std::string kind : {"rectangle", "mesh", "sphere", "disk"}) {
        const auto check = [=](const End& end, const Run& run) { return light_is_seen(kind, end, run); };
        std::vector<Wrong<End>> wrong{{"end-behind", "Shadow rays end behind the light's surface.", end_behind}};
        if (kind == "rectangle" || kind == "mesh")
            wrong.push_back(
                {"end-in-double", "Shadow rays end as if the light were met in double precision.", end_in_double});
        catalogue.add({.id = "direct/visibility/" + kind,
                       .statement = "No sample of a " + kind +
                                    " light in full sight is hidden, by the light itself or by the floor, up to 2^12 "
                                    "sizes from the world's origin.",
                       .source = "ours, scenes/geometry/surface_point.h",
                       .kind = Kind::exact,
                       .trial = {check, [](const SurfacePoint& point) { return point; }, std::move(wrong)}});
    }
}

// ---- masks

constexpr double opacity = 0.3, second_opacity = 0.5;

/// A floor under two masks and above them a light.
Scene under_masks(bool point_light, double first, double second) {
    description::Scene scene;
    add_receiver(scene, {}, {0, 0, 1}, add_material(scene));
    const auto black = add_material(scene, description::Diffuse{Spectrum{}});
    double height = 0.5;
    for (const double o : {first, second}) {
        add_receiver(scene, {0.1, -0.05, height}, {0, 0, 1},
                     add_material(scene, description::Mask{Spectrum::grey(o), black}), 4);
        height += 0.25;
    }
    if (point_light)
        scene.emitters.emplace_back().kind = description::PointLight{{0, 0, 2}, Spectrum::grey(4)};
    else
        add_polygon(scene, {{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}}, black, white);
    scene.sensor = camera({0.05, 0, 0.2}, {});
    return Scene(std::move(scene));
}

/// ρ/π I/d² of a point light of 4 W/sr at distance 2: 1/π.
struct FirstMask {
    double opacity;
    NextEvent next_event;
};
Verdict share_of_point(const FirstMask& first, const Run& run) {
    const Scene scene = under_masks(true, first.opacity, second_opacity);
    const Direct estimator(first.next_event);
    const Measurement measurement{.scene = scene, .estimator = estimator, .film = Point<2>{0.5, 0.5}, .n = 1};
    const double reference = (1 - opacity) * (1 - second_opacity) / pi;
    return mean_is([&](RandomStream& random) { return measurement.draw(random)[0]; },
                   {.reference = reference, .delta = 1e-3, .epsilon = 1e-6, .zero_variance = true}, run);
}

/// Where camera rays pass two masks to a light of radiance 1, the mean of what they see is (1 − o)(1 − o').
Verdict share_of_camera_rays(double first, const Run& run) {
    description::Scene scene = under_masks(false, first, second_opacity).description();
    scene.sensor = camera({0.1, 0, 0.1}, {0.1, 0, 1});
    const Scene seen(std::move(scene));
    const Direct estimator;
    const Measurement measurement{
        .scene = seen, .estimator = estimator, .film = Point<2>{0.5, 0.5}, .n = 16, .edges = 1};
    const double reference = (1 - opacity) * (1 - second_opacity);
    return mean_is([&](RandomStream& random) { return measurement.draw(random)[0]; },
                   {.reference = reference, .delta = 5e-3 * reference, .epsilon = 1e-9, .bounds = {0, 1}}, run);
}

struct Unhidden final : Visibility {
    [[nodiscard]] double sample(const Scene&, const SurfacePoint&, const LightSample&, SampleIndex, Draws&,
                                RayLog&) const override {
        return 1;
    }
};
struct Solid final : Visibility {
    [[nodiscard]] double sample(const Scene& scene, const SurfacePoint& from, const LightSample& end, SampleIndex,
                                Draws&, RayLog& rays) const override {
        return scene.transmittance(from, end, rays) < 1 ? 0 : 1;
    }
};

void add_masks(Catalogue& catalogue) {
    NextEvent no_masks, solid;
    no_masks.visibility = std::make_shared<Unhidden>();
    solid.visibility = std::make_shared<Solid>();
    const NextEvent right;
    catalogue.add({.id = "direct/mask/shadow-ray",
                   .statement = "Masks of opacities o and o' let (1 − o)(1 − o') of a point's light through.",
                   .source = "docs/scenes.md",
                   .kind = Kind::mean,
                   .trial = {share_of_point,
                             {opacity, right},
                             {{"no-shadow-ray", "Nothing hides the light.", {opacity, no_masks}},
                              {"solid", "A mask hides as a surface does.", {opacity, solid}},
                              {"inverted", "What is let through is o, not 1 − o.", {1 - opacity, right}}}}});
    catalogue.add(
        {.id = "direct/mask/camera-ray",
         .statement = "A light behind masks of opacities o and o' is seen with (1 − o)(1 − o') of its radiance.",
         .source = "docs/scenes.md",
         .kind = Kind::mean,
         .trial = {share_of_camera_rays,
                   opacity,
                   {{"inverted", "What is let through is o, not 1 − o.", 1 - opacity},
                    {"slightly-thin", "The first mask's opacity is 0.29 instead of 0.3.", 0.29}}}});
}

}  // namespace

void add_direct_visibility(Catalogue& catalogue) {
    add_ends(catalogue);
    add_masks(catalogue);
}

}  // namespace plumb::suites
