// Masks on lights: whoever finds the light, by a ray that meets it, by sampling it or from its own rays, finds the
// share of it that its opacity lets stop a ray.

#include <map>

#include "verification/suites/suites.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

using Made = std::shared_ptr<const PathEstimator>;

constexpr double opacity = 0.25;
enum class Opacity { even, textured };

// A mesh of five sides whose normals turn its triangles' order, so that corners and their uv are told apart.
Mesh pentagon() {
    Mesh mesh;
    mesh.positions = {
        {-0.9f, -0.5f, 1.2f}, {0, -0.8f, 1.3f}, {0.9f, -0.4f, 1.2f}, {0.7f, 0.7f, 1.1f}, {-0.8f, 0.6f, 1.2f}};
    mesh.normals.assign(5, {0, 0, -1});
    mesh.uvs = {{0, 0}, {0.8f, 0.1f}, {0.9f, 0.6f}, {0.5f, 1}, {0.1f, 0.7f}};
    for (std::uint32_t i = 2; i < 5; ++i) mesh.triangles.push_back({0, i - 1, i});
    return mesh;
}

description::Scene lit_by(const std::string& kind, Opacity of) {
    description::Scene scene;
    const auto floor = add_material(scene, description::Diffuse{Spectrum::grey(0.6)});
    const auto black = add_material(scene, description::Diffuse{Spectrum{}});
    description::Colour lets_through = Spectrum::grey(opacity);
    if (of == Opacity::textured) {
        scene.textures.emplace_back().kind = description::Checkerboard{Spectrum::grey(0.9), Spectrum::grey(0.1)};
        lets_through = description::TextureId{0};
    }
    const auto gauze = add_material(scene, description::Mask{lets_through, black});
    const Spectrum radiance = Spectrum::grey(4);
    add_polygon(scene, {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, floor);
    if (kind == "rectangle")
        add_polygon(scene, {{-0.8, -0.6, 1.2}, {-0.8, 0.6, 1.2}, {0.8, 0.6, 1.2}, {0.8, -0.6, 1.2}}, gauze, radiance);
    if (kind == "mesh") add_shape(scene, pentagon(), gauze, radiance);
    if (kind == "sphere")
        add_shape(
            scene,
            description::Sphere{
                {0.1, 0.2, 1.4}, 0.6, false, Transform::translate({0.1, 0.2, 1.4}) * Transform::scale({0.6, 0.6, 0.6})},
            gauze, radiance);
    if (kind == "disk")
        add_shape(scene, description::Disk{{0, 0.1, 1.3}, {0, 0.8, 0}, {0.8, 0, 0}, {0, 0, -1}}, gauze, radiance);
    scene.sensor = camera({0, -4, 1}, {0, 0, 0}, 20, 8, 8);
    return scene;
}

const Scene& scene_of(const std::string& kind, Opacity of) {
    static const std::map<std::pair<std::string, Opacity>, std::shared_ptr<const Scene>> scenes = [] {
        std::map<std::pair<std::string, Opacity>, std::shared_ptr<const Scene>> all;
        for (const char* one : {"rectangle", "mesh", "sphere", "disk"})
            for (const Opacity either : {Opacity::even, Opacity::textured})
                all[{one, either}] = std::make_shared<const Scene>(lit_by(one, either));
        return all;
    }();
    return *scenes.at({kind, of});
}

// The choice of the scene, with samples of lights as they would be without masks.
struct IgnoresMask final : LightChoice {
    [[nodiscard]] std::optional<SceneLightSample> sample(const Scene& scene, const SurfacePoint& from,
                                                         SampleIndex index, Draws& draws) const override {
        auto light = choice_by_power()->sample(scene, from, index, draws);
        if (!light) return light;
        const Point<2> u = draws.at(index.slot(Use::light_point));
        light->sample.radiance =
            std::visit([&](const auto& one) { return one.sample(from.position, u)->radiance; }, scene.lights()[0]);
        return light;
    }
    [[nodiscard]] double pdf(const Scene& scene, const SurfacePoint& from, const LightPoint& point) const override {
        return choice_by_power()->pdf(scene, from, point);
    }
};

constexpr PathLimits two_edges{.max_edges = 2};

NextEvent ignoring_masks() {
    NextEvent next_event;
    next_event.lights = {{std::make_shared<IgnoresMask>()}};
    return next_event;
}
Made path_ignoring_masks() {
    auto path = std::make_shared<PathTracer>(two_edges);
    path->next_event = ignoring_masks();
    return path;
}
Made light() {
    return std::make_shared<LightTracer>(two_edges);
}
Made bdpt(const std::optional<Strategy>& alone = {}) {
    PathLimits limits = two_edges;
    limits.strategy = alone;
    return std::make_shared<Bdpt>(limits);
}
Made bdpt_ignoring_masks(const std::optional<Strategy>& alone = {}) {
    PathLimits limits = two_edges;
    limits.strategy = alone;
    auto other = std::make_shared<Bdpt>(limits);
    other->choice = std::make_shared<IgnoresMask>();
    return other;
}

/// All against rays of the BSDF alone, which meet the light and know nothing of samples.
Verdict all_find_what_rays_find(const Scene& scene, const std::vector<Made>& all, const Run& run) {
    const Direct by_rays(bsdf_alone);
    const RegionMean met{scene, by_rays, whole_film(scene)};
    double unit = 0;  // of δ
    for (std::uint64_t i = 0; i < 64; ++i) {
        RandomStream random = run.random(i);
        unit += met.draw(random) / 64;
    }
    std::vector<Verdict> parts;
    for (const Made& one : all)
        parts.push_back(same_mean(met, {scene, *one, whole_film(scene)},
                                  {.delta = run.pick(0.1, 0.01) * unit,
                                   .epsilon = 1e-5 * unit,
                                   .why_fewer = "paths in every pixel towards a light that fills much of the sky",
                                   .cap = run.pick(1u << 16, 1u << 22)},
                                  run.part(fmt::format("{}", parts.size()), 1 / static_cast<double>(all.size()))));
    return all_of(std::move(parts));
}

Verdict masks_of_kind(const std::string& kind, const std::vector<Made>& all, const Run& run) {
    std::vector<Verdict> parts;
    for (const Opacity of : {Opacity::even, Opacity::textured})
        parts.push_back(
            all_find_what_rays_find(scene_of(kind, of), all, run.part(of == Opacity::even ? "even" : "textured", 0.5)));
    return all_of(std::move(parts));
}

void add_kind(Catalogue& catalogue, const std::string& kind) {
    const auto check = [kind](const std::vector<Made>& all, const Run& run) { return masks_of_kind(kind, all, run); };
    catalogue.add(
        {.id = "render/masked-light/" + kind,
         .statement = "`path`, samples of lights alone, `light` and `bdpt` find the light of a " + kind +
                      " under an even and a textured mask that rays of the BSDF find.",
         .source = "docs/render.md",
         .kind = Kind::mean,
         .trial = {
             check,
             std::vector<Made>{std::make_shared<PathTracer>(two_edges), std::make_shared<Direct>(lights_alone), light(),
                               bdpt()},
             {{"samples-ignore-masks", "A sample of a light carries all of its radiance.", {path_ignoring_masks()}},
              {"rays-ignore-masks",
               "A light sends rays as if it were bare.",
               {std::make_shared<Scaled>(light(), 1 / opacity)}},
              {"bdpt-ignores-masks",
               "Strategies (1, t) carry all of the light's radiance.",
               {bdpt_ignoring_masks()}}}}});
}

void add_strategies(Catalogue& catalogue) {
    const auto check = [](const std::vector<Made>& all, const Run& run) {
        return all_find_what_rays_find(scene_of("mesh", Opacity::textured), all, run);
    };
    catalogue.add(
        {.id = "render/masked-light/strategies",
         .statement =
             "Each strategy of two edges that samples the light finds it under a textured mask as rays of the BSDF do.",
         .source = "docs/render.md",
         .kind = Kind::mean,
         .trial = {check,
                   std::vector<Made>{bdpt(Strategy{1, 2}), bdpt(Strategy{2, 1})},
                   {{"samples-ignore-masks",
                     "Strategy (1, 2) carries all of the light's radiance.",
                     {bdpt_ignoring_masks(Strategy{1, 2})}},
                    {"rays-ignore-masks",
                     "Strategy (2, 1) starts as if the light were bare.",
                     {std::make_shared<Scaled>(bdpt(Strategy{2, 1}), 2)}}}}});
}

}  // namespace

void add_transport_masked_lights(Catalogue& catalogue) {
    for (const char* kind : {"rectangle", "mesh", "sphere", "disk"}) add_kind(catalogue, kind);
    add_strategies(catalogue);
}

}  // namespace plumb::suites
