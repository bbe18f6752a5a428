// `plumb compare` on trial with renders of a scene: honest ones, and ones by renderers with a defect.

#include <fmt/format.h>

#include "core/srgb.h"
#include "integrators/drivers/render.h"
#include "integrators/estimators/light_tracer.h"
#include "integrators/estimators/path.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/suites/comparison/compare_subjects.h"
#include "verification/suites/direct/direct_subjects.h"

namespace plumb::suites {
namespace {

// ---- a still life of 32x32 pixels

constexpr std::size_t ball = 0, point = 1;  // among the shapes, and among the lights

/// What it is seen with: defects of a camera.
struct Lens {
    double filter_radius = 1, aside = 0;  ///< of the tent, in pixels; how far the picture is moved
};

/// A ball before a wall, a deep white shelf to its right, a lamp above the camera, and a point light above the ball;
/// the floor ends where a row of tiles does.
description::Scene still_life(const Lens& lens) {
    description::Scene scene;
    const auto diffuse = [&](double r, double g, double b) {
        return add_material(scene, description::Diffuse{Spectrum::rgb(r, g, b)});
    };
    const auto wall = diffuse(0.7, 0.7, 0.6), floor = diffuse(0.2, 0.15, 0.1), white = diffuse(0.92, 0.92, 0.92),
               red = diffuse(0.7, 0.3, 0.2), black = diffuse(0, 0, 0);
    const auto plate = [&](Vec3 corner, Vec3 edge_1, Vec3 edge_2, description::MaterialId material,
                           std::optional<Spectrum> radiance = {}) {
        add_polygon(scene, {corner, corner + edge_1, corner + edge_1 + edge_2, corner + edge_2}, material, radiance);
    };
    const Vec3 centre{-1, 0.3, -0.3};
    constexpr double radius = 0.6;
    add_shape(scene,
              description::Sphere{centre, radius, false,
                                  Transform::translate(centre) * Transform::scale({radius, radius, radius})},
              red);
    plate({-4, -3, -1}, {8, 0, 0}, {0, 5, 0}, floor);
    plate({-4, 2, -1}, {8, 0, 0}, {0, 0, 5}, wall);
    plate({0.5, 0.2, -0.99}, {1.4, 0, 0}, {0, 1.4, 0}, white);  // the shelf: bottom,
    plate({0.5, 0.2, 0.4}, {0, 1.4, 0}, {1.4, 0, 0}, white);    // top,
    plate({0.5, 1.6, -1}, {1.4, 0, 0}, {0, 0, 1.4}, white);     // back,
    plate({0.5, 0.2, -1}, {0, 1.4, 0}, {0, 0, 1.4}, white);     // and sides
    plate({1.9, 0.2, -1}, {0, 0, 1.4}, {0, 1.4, 0}, white);
    plate({-0.3, -3, 2.2}, {0, 0.6, 0.6}, {1, 0, 0}, black, Spectrum::grey(60));  // shines forwards and down
    description::Emitter& light = scene.emitters.emplace_back();
    light.kind = description::PointLight{{-1.2, 1.2, 1.2}, Spectrum::rgb(9, 9, 7)};
    constexpr int edge = 32;
    constexpr double height = 0.456, pixel_at_target = 2 * 0.36397 * 6 / edge;
    description::Sensor sensor;
    sensor.to_world = Transform::look_at({0, -6, height}, {0, 0, height + lens.aside * pixel_at_target}, {0, 0, 1});
    sensor.kind = description::Perspective{40};
    sensor.film = {edge, edge, TentFilter(lens.filter_radius)};
    scene.sensor = sensor;
    return scene;
}

const Scene& honest_scene() {
    static const Scene scene(still_life({}));
    return scene;
}

const Scene& scene_aside() {
    static const Scene scene(still_life({.aside = 0.5}));
    return scene;
}
const Scene& blurry_scene() {
    static const Scene scene(still_life({.filter_radius = 2}));
    return scene;
}

// ---- renderers

using Renderer = std::shared_ptr<const PathEstimator>;

struct Job {
    const Scene& (*scene)();
    Renderer renderer;
    RenderSettings settings;

    [[nodiscard]] Image operator()(std::uint64_t seed) const {
        RenderSettings seeded = settings;
        seeded.seed = seed;
        const Film film = render(scene(), *renderer, seeded).film;
        Image image{
            settings.crop.width, settings.crop.height, {"R", "G", "B", "variance.R", "variance.G", "variance.B"}, {}};
        image.metadata = {{"plumb:replicates", fmt::format("{}", film.replicates())}};
        for (int i = 0; i < image.width * image.height; ++i) {
            const int x = i % image.width, y = i / image.width;
            for (std::size_t c = 0; c < 3; ++c) image.values.push_back(static_cast<float>(film.mean(x, y, c)));
            for (std::size_t c = 0; c < 3; ++c)
                image.values.push_back(static_cast<float>(film.variance_of_mean(x, y, c)));
        }
        return image;
    }
};

constexpr FilmRegion whole{0, 0, 32, 32}, by_the_point{0, 0, 16, 16};

/// Settings of 16 passes; see RenderSettings.
RenderSettings samples(const std::string& sampler, std::uint32_t per_pass, const FilmRegion& crop = whole) {
    return {.sampler = sampler, .samples_per_pass = per_pass, .crop = crop};
}

template <class E>
Renderer by(const E& estimator) {
    return std::make_shared<E>(estimator);
}
Direct direct_with(const NextEvent& next_event) {
    return Direct(lights_alone, next_event);
}
Renderer direct() {
    return by(direct_with({}));
}
Renderer path(int longest = -1) {
    return by(PathTracer({.max_edges = longest}));
}

/// A job by direct light, of so many Sobol samples a pass.
Job still(std::uint32_t per_pass) {
    return {honest_scene, direct(), samples("sobol", per_pass)};
}

// ---- defects

/// Light on the ball without its cosine.
struct WithoutCosineOnBall final : Visibility {
    [[nodiscard]] double sample(const Scene& scene, const SurfacePoint& from, const LightSample& end, SampleIndex index,
                                Draws& draws, RayLog& rays) const override {
        const double arrives = shadow_rays()->sample(scene, from, end, index, draws, rays);
        const auto& sphere = std::get<description::Sphere>(scene.description().shapes[ball].geometry);
        const bool on_ball = std::abs(length(from.position - sphere.center) / sphere.radius - 1) < 1e-4;
        return on_ball ? arrives / std::abs(dot(from.normal, end.direction)) : arrives;
    }
};

struct WithoutPointAtTimes final : LightChoice {
    [[nodiscard]] std::optional<SceneLightSample> sample(const Scene& scene, const SurfacePoint& from,
                                                         SampleIndex index, Draws& draws) const override {
        const auto light = choice_by_power()->sample(scene, from, index, draws);
        const bool left_out = light && light->light == point && draws.at(index.slot(Use::wavelength))[0] < 0.01;
        return left_out ? std::nullopt : light;
    }
    [[nodiscard]] double pdf(const Scene& scene, const SurfacePoint& from, const LightPoint& at) const override {
        return choice_by_power()->pdf(scene, from, at);
    }
};

/// Splats are cut off at this value.
struct Clamped final : PathEstimator {
    Renderer renderer;
    double most;
    Clamped(Renderer of, double value) : renderer(std::move(of)), most(value) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& numbers,
               PathRecord& record) const override {
        renderer->trace(scene, region, numbers, record);
        for (Splat& splat : record.splats)
            for (double& value : splat.value.lane) value = std::min(value, most);
    }
};

// ---- pairs

Pair against(const Job& honest, const std::function<Image(std::uint64_t)>& spoiled) {
    return [=](std::uint64_t seed) { return std::pair{honest(2 * seed), spoiled(2 * seed + 1)}; };
}

/// Four images of each side: of one, differences that neighbours share look like errors that they share.
Pair fours(const std::function<Image(std::uint64_t)>& honest, const std::function<Image(std::uint64_t)>& spoiled) {
    const auto four = [](const std::function<Image(std::uint64_t)>& image, std::uint64_t seed) {
        std::vector<Image> images;
        for (std::uint64_t i = 0; i < 4; ++i) images.push_back(image(4 * seed + i));
        return Renders(std::move(images));
    };
    return [=](std::uint64_t seed) { return TwoSides{four(honest, 2 * seed), four(spoiled, 2 * seed + 1)}; };
}

std::vector<Spoiled> images_spoiled() {
    const Job honest = still(8), precise = still(16);
    const auto spoil = [&](const std::function<Image(Image)>& how) {
        return against(honest, [=](std::uint64_t seed) { return how(honest(seed)); });
    };
    const auto change = [&](const Change& how) {
        return spoil([=](Image image) { return changed(std::move(image), how); });
    };
    constexpr PixelBox bright_wall{0, 0, 16, 16};
    return {{"dark-tile",
             "One tile 3 % darker.",
             change([](double v, int x, int y) { return x >= 16 && y < 16 ? 0.97 * v : v; }),
             {16, 0, 16, 16}},
            {"srgb-as-linear", "sRGB written as if it were linear.",
             change([](double v, int, int) { return srgb_from_linear(v); })},
            {"eight-bits", "Written in 8 bits and read again: the wall by the light is cut off.", spoil(in_bytes),
             bright_wall},
            {"blurred", "Blurred over 3x3 pixels.",
             against(precise, [=](std::uint64_t seed) { return blurred(precise(seed)); })}};
}

std::vector<Spoiled> renderers_spoiled() {
    NextEvent no_cosine, point_left_out;
    no_cosine.visibility = std::make_shared<WithoutCosineOnBall>();
    point_left_out.lights = {{std::make_shared<WithoutPointAtTimes>()}};
    const Job honest = still(4), closer = still(8), precise = still(16);
    const Job long_paths{honest_scene, path(), samples("sobol", 4)},
        noisy{honest_scene, direct(), samples("independent", 4)},
        by_lights{honest_scene, direct(), samples("sobol", 64, by_the_point)},
        by_bsdf{honest_scene, by(Direct(bsdf_alone)), samples("independent", 8)};
    const auto spoiled = [&](Job job, Renderer renderer) {
        job.renderer = std::move(renderer);
        return job;
    };
    constexpr PixelBox on_ball{4, 17, 10, 10};
    return {
        {"brighter", "1 % brighter.",
         fours(closer,
               [=](std::uint64_t seed) { return changed(closer(seed), [](double v, int, int) { return 1.01 * v; }); })},
        {"cosine-missing", "Light on the ball without its cosine.",
         against(honest, spoiled(honest, by(direct_with(no_cosine)))), on_ball},
        {"light-missing", "The point light is left out in 1 % of its samples.",
         against(by_lights, spoiled(by_lights, by(direct_with(point_left_out))))},
        {"depth-limited", "No path has more than 3 edges.", fours(long_paths, spoiled(long_paths, path(3)))},
        {"half-pixel", "Half a pixel aside.", fours(honest, Job{scene_aside, direct(), honest.settings})},
        {"filter-width", "A filter of twice the width.",
         against(precise, Job{blurry_scene, direct(), precise.settings})},
        {"fireflies-clamped", "Samples are cut off at 2.",
         against(by_bsdf, spoiled(by_bsdf, std::make_shared<Clamped>(by_bsdf.renderer, 2.0)))},
        {"seeds-overlap", "Half of the passes are those of the other render.", [=](std::uint64_t seed) {
             Job second = noisy;  // of passes 8 to 23 of the same seed
             second.settings.passes = 24;
             second.settings.first_pass = 8;
             return std::pair{noisy(seed), second(seed)};
         }}};
}

TwoSides honest_pair(std::uint64_t number, RandomStream& random, double variance_scale) {
    std::vector<Job> jobs{{honest_scene, path(5), samples("independent", 1)},
                          {honest_scene, direct(), samples("independent", 1)},
                          {honest_scene, by(LightTracer({.max_edges = 4})), samples("independent", 1)},
                          {honest_scene, by(Direct()), samples("sobol", 4, by_the_point)}};
    Job& job = jobs[number % jobs.size()];
    job.settings.passes = 4;
    Image first = with_variance(job(random.bits()), variance_scale);
    return {std::move(first), with_variance(job(random.bits()), variance_scale)};
}

Verdict honest_pairs(double variance_scale, const Run& run) {
    return pairs_are_not_refuted(
        [=](std::uint64_t number, RandomStream& random) { return honest_pair(number, random, variance_scale); }, run);
}

}  // namespace

void add_comparison_renders(Catalogue& catalogue) {
    std::vector<Spoiled> spoiled = images_spoiled();
    for (Spoiled& render : renderers_spoiled()) spoiled.push_back(std::move(render));
    Job honest = still(4);
    honest.settings.passes = 64;
    const auto comparison_of_renders_shows = [](const Compared& subject, const Run& run) {
        constexpr int tile = 16;  // of smaller ones a few pixels have all the variance: no skewness is known well
        return comparison_shows(subject, run, tile);
    };
    catalogue.add({.id = "render/compare/renderers",
                   .statement = "Two renders of a scene are found equal; one by a renderer with a defect is refuted, "
                                "at the place of the defect.",
                   .source = "ours, docs/compare.md",
                   .kind = Kind::mean,
                   .trial = {comparison_of_renders_shows, {against(honest, honest)}, std::move(spoiled)}});
    catalogue.add(
        {.id = "render/compare/honest-renders",
         .statement = "200 pairs of renders by `path`, `light` and `direct` are not refuted.",
         .source = "ours, docs/compare.md",
         .kind = Kind::mean,
         .trial = {
             honest_pairs, 1, {{"quarter-variance", "Layers of variances that are four times too small.", 0.25}}}});
}

}  // namespace plumb::suites
