// Pixels of renders: no value that should not be, the same bits on any number of threads, textures where they belong,
// a constant scene constant.

#include "core/parallel.h"
#include "integrators/drivers/render.h"
#include "integrators/drivers/sampler.h"
#include "integrators/estimators/aov.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"
#include "scenes/textures/texture.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/suites/direct/direct_subjects.h"

namespace plumb::suites {
namespace {

using Estimator = std::shared_ptr<const PathEstimator>;

// ---- values

/// The whole picture in few pixels.
Scene small(const ShippedScene& shipped, int width) {
    description::Scene scene = load_mitsuba(shipped.file);
    description::Film& film = scene.sensor->film;
    film.height = std::max(1, film.height * width / film.width);
    film.width = width;
    return Scene(std::move(scene));
}

Verdict values_are_sound(const ShippedScene& shipped, const std::vector<Estimator>& estimators, const Run& run) {
    const Scene scene = small(shipped, run.pick(32, 160));
    const FilmSize film = scene.sensor().film();
    BadValues bad;
    std::uint64_t samples = 0;
    for (const Estimator& estimator : estimators) {
        RandomStream random = run.random(0);
        run.end_if_stopped();
        const RenderSettings settings{.samples_per_pass = run.pick(2u, 16u),
                                      .passes = 1,
                                      .seed = random.bits(),
                                      .crop = {0, 0, film.width, film.height}};
        bad.merge(render(scene, *estimator, settings).film.bad_values());
        samples += static_cast<std::uint64_t>(film.width) * static_cast<std::uint64_t>(film.height) *
                   settings.samples_per_pass;
    }
    return exactly(bad == BadValues(), samples,
                   fmt::format("{} values are NaN, {} infinite, {} negative", bad.nan, bad.infinite, bad.negative));
}

/// The density with which light samples of another place would find what the camera sees: 0 for most of it.
double density_elsewhere(const Scene& scene, const PathRecord& record) {
    return record.vertices.empty() ? 1 : scene.light_pdf(record.vertices[0].hit, {}, {0, 0, 1});
}

/// Direct light times a factor that a path gives.
struct Changed final : PathEstimator {
    using Factor = double (*)(const Scene&, PrimarySamples&, const PathRecord&);
    Factor factor;
    explicit Changed(Factor f) : factor(f) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        Direct().trace(scene, region, samples, record);
        const double by = factor(scene, samples, record);
        for (Splat& splat : record.splats) splat.value *= by;
    }
};

std::vector<Estimator> changed(Changed::Factor factor) {
    return {std::make_shared<Changed>(factor)};
}

std::vector<Wrong<std::vector<Estimator>>> unsound() {
    return {{"nan", "A weight is 0/0 where both densities are 0.",
             changed([](const Scene& scene, PrimarySamples&, const PathRecord& record) {
                 const double p = density_elsewhere(scene, record);
                 return p / (p + p);
             })},
            {"infinite", "A density of 0 is divided by.",
             changed([](const Scene& scene, PrimarySamples&, const PathRecord& record) {
                 return 1 / density_elsewhere(scene, record);
             })},
            {"negative", "A control variate takes more than there is.",
             changed([](const Scene&, PrimarySamples& samples, const PathRecord&) {
                 return 1 - 2 * samples.at({1, Use::roulette}).u[0];
             })}};
}

void add_values(Catalogue& catalogue) {
    for (const ShippedScene& shipped : shipped_scenes()) {
        const auto check = [=](const std::vector<Estimator>& estimators, const Run& run) {
            return values_are_sound(shipped, estimators, run);
        };
        catalogue.add(
            {.id = fmt::format("direct/{}/sound", shipped.name),
             .statement = fmt::format(
                 "No NaN, infinite or negative radiance, albedo or depth in pictures of the scene {}.", shipped.name),
             .source = "ours, scenes/film/film.h",
             .kind = Kind::exact,
             .trial = {check,
                       {std::make_shared<Direct>(), std::make_shared<Direct>(lights_alone),
                        std::make_shared<Direct>(bsdf_alone), std::make_shared<Aov>()},
                       unsound()},
             // Loading it takes seconds.
             .sizes = shipped.name == "million_triangles" ? Sizes::full_only : Sizes::both});
    }
}

// ---- threads

/// The picture that some number of threads render.
using Picture = std::function<Rendered(const Scene&, int threads)>;

Verdict same_bits(const Picture& picture, const Run&) {
    description::Scene description = load_mitsuba(scene_file("cornell_box"));
    description.sensor->film.width = description.sensor->film.height = 48;
    const Scene scene(std::move(description));
    const Rendered one = picture(scene, 1), two = picture(scene, 2);
    const Image a = one.film.image(), b = two.film.image();
    return exactly(a.values == b.values && one.rays == two.rays, a.values.size(),
                   a.values == b.values ? "the same bits" : "pixels differ between 1 and 2 threads");
}

void add_threads(Catalogue& catalogue) {
    for (const std::string sampler : {"independent", "stratified", "sobol"}) {
        const auto picture = [=](const std::function<std::uint64_t(int)>& seed) -> Picture {
            return [=](const Scene& scene, int threads) {
                std::optional<Rendered> rendered;
                const RenderSettings settings{sampler, 4, 2, seed(threads), {0, 0, 48, 48}};
                with_threads(threads, [&] { rendered = render(scene, Direct(), settings); });
                return *rendered;
            };
        };
        const auto check = [=](const std::function<std::uint64_t(int)>& seed, const Run& run) {
            return same_bits(picture(seed), run);
        };
        catalogue.add({.id = "direct/threads/" + sampler,
                       .statement = fmt::format("1 and 2 threads give the same bits with {} samples.", sampler),
                       .source = "ours, integrators/drivers/render.h",
                       .kind = Kind::exact,
                       .trial = {check,
                                 [](int) { return 7; },
                                 {{"seed-by-threads", "The seed depends on the number of threads.",
                                   [](int threads) { return static_cast<std::uint64_t>(threads); }}}}});
    }
}

// ---- textures

constexpr int film_side = 32;

/// A square whose texture fills the film: u grows with the film's x, v against its y.
description::Scene textured(description::Texture texture) {
    description::Scene scene;
    scene.textures.push_back(std::move(texture));
    const auto material = add_material(scene, description::Diffuse{description::TextureId{0}});
    add_polygon(scene, {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}}, material);
    scene.sensor = camera({0, 0, 0.5}, {}, 90, film_side, film_side);
    scene.sensor->to_world = Transform::look_at({0, 0, 0.5}, {}, {0, 1, 0});
    return scene;
}

using ColourAt = std::function<Spectrum(double u, double v)>;

Verdict shows(const description::Texture& texture, const ColourAt& truth, double film_shift, const Run& run) {
    const Scene scene(textured(texture));
    std::vector<BoundedCase> cases;
    PathRecord record;
    IndependentSamples none;
    for (std::uint64_t i = 0; i < run.pick(1000u, 20'000u); ++i) {
        RandomStream random = run.random(i);
        const double x = film_side * random.uniform(), y = film_side * random.uniform();
        const double u = x / film_side, v = 1 - y / film_side;
        AtFilmPoint at_point(scene, {x + film_shift, y}, none);
        Aov().trace(scene, at_point.pixel(), at_point, record);
        const Spectrum off = record.sum() - truth(u, v);
        const double error = std::max({std::abs(off[0]), std::abs(off[1]), std::abs(off[2])});
        cases.push_back({fmt::format("u = {}, v = {}", u, v), error, u});
    }
    return within_bound(cases, 1e-4, "albedo");
}

/// Σ of the texels times hats of width one texel around their centres; beyond the edge the last ones go on.
Spectrum hats(const Texels& texels, double u, double v) {
    Spectrum sum;
    const double x = u * texels.width - 0.5, y = v * texels.height - 0.5;
    for (int j = static_cast<int>(std::floor(y)); j <= std::floor(y) + 1; ++j)
        for (int i = static_cast<int>(std::floor(x)); i <= std::floor(x) + 1; ++i)
            sum += texels.texel(std::clamp(i, 0, texels.width - 1), std::clamp(j, 0, texels.height - 1)) *
                   ((1 - std::abs(x - i)) * (1 - std::abs(y - j)));
    return sum;
}

/// Squares of side ½; near their sides, floats decide.
Spectrum squares(const description::Checkerboard& board, double u, double v) {
    return (u < 0.5) == (v < 0.5) ? board.color0 : board.color1;
}

description::Texture moved(description::Texture texture, double du, double dv) {
    texture.to_uv = Transform::translate({du, dv, 0});
    return texture;
}

void add_textures(Catalogue& catalogue) {
    const std::filesystem::path file = scene_file("interior").parent_path() / "painting.png";
    const description::Texture painting{description::Bitmap{file, false, description::Wrap::clamp}, {}, {}};
    struct Aside {
        double texels, pixels;
    };
    const auto bitmap = [=](const Aside& aside, const Run& run) {
        const Texels texels = read_texels(file);
        return shows(
            moved(painting, aside.texels / texels.width, 0), [&](double u, double v) { return hats(texels, u, v); },
            aside.pixels, run);
    };
    catalogue.add({.id = "direct/texture/bitmap",
                   .statement = "The camera sees a bitmap where its texels lie, bilinear between their centres.",
                   .source = "docs/scenes.md",
                   .kind = Kind::bounded,
                   .trial = {bitmap,
                             {0, 0},
                             {{"half-a-texel", "The texture lies half a texel aside.", {0.5, 0}},
                              {"half-a-pixel", "The film lies half a pixel aside.", {0, 0.5}}}}});
    const description::Checkerboard board{Spectrum::rgb(0.4, 0.3, 0.1), Spectrum::grey(0.2)};
    const auto checkerboard = [=](double aside, const Run& run) {
        return shows(
            moved({board, {}, {}}, aside, 0), [&](double u, double v) { return squares(board, u, v); }, 0, run);
    };
    catalogue.add({.id = "direct/texture/checkerboard",
                   .statement = "The camera sees a checkerboard's squares where they lie.",
                   .source = "docs/scenes.md",
                   .kind = Kind::bounded,
                   .trial = {checkerboard, 0, {{"aside", "It lies a hundredth aside.", 0.01}}}});
}

// ---- a constant picture

/// Weighs the film point by the filter, 1 at the pixel's centre, though it was drawn by the filter already.
struct FilterWeighted final : PathEstimator {
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        Direct().trace(scene, region, samples, record);
        for (Splat& splat : record.splats)
            splat.value *= std::visit([&](const auto& f) { return f.pdf(splat.film[0] - region.x - 0.5) / f.pdf(0); },
                                      scene.sensor().filter());
    }
};

Verdict picture_is_one(const Filter& filter, const PathEstimator& estimator, const Run& run) {
    description::Scene description;
    description.emitters.push_back({description::ConstantSky{Spectrum::grey(1)}, {}});
    add_shape(description, description::Sphere{{}, 1, false, {}}, add_material(description));
    description.sensor = camera({0, 0, -4}, {}, 40, 16, 16);
    description.sensor->film.filter = filter;
    const Scene scene(std::move(description));
    RandomStream random = run.random(0);
    const Rendered picture =
        render(scene, estimator, {.samples_per_pass = 4, .passes = 1, .seed = random.bits(), .crop = {0, 0, 16, 16}});
    std::vector<BoundedCase> cases;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            cases.push_back({fmt::format("pixel ({}, {})", x, y), std::abs(picture.film.mean(x, y, 0) - 1)});
    return within_bound(cases, 1e-9, "radiance");
}

void add_constant(Catalogue& catalogue) {
    // By samples of its BSDF a white sphere under a white sky is white without variance.
    const auto direct = std::make_shared<Direct>(bsdf_alone);
    for (const auto& [name, filter] : std::initializer_list<std::pair<const char*, Filter>>{
             {"box", BoxFilter()}, {"tent", TentFilter(1.5)}, {"gaussian", GaussianFilter(0.5)}}) {
        std::vector<Wrong<Estimator>> wrong{
            {"two-thousandths-bright", "Everything is 0.2 % too bright.", std::make_shared<Scaled>(direct, 1.002)},
            {"weighted-again", "The filter's value, not normalised, is a weight once more.",
             std::make_shared<FilterWeighted>()}};
        if (std::holds_alternative<BoxFilter>(filter)) wrong.pop_back();  // its weight is 1 everywhere
        catalogue.add({
            .id = fmt::format("direct/constant/{}", name),
            .statement =
                fmt::format("A white sphere under a white sky gives a picture of ones with the film filter {}.", name),
            .source = "ours, scenes/film/filters.h",
            .kind = Kind::bounded,
            .trial = {[filter = filter](const Estimator& estimator, const Run& run) {
                          return picture_is_one(filter, *estimator, run);
                      },
                      direct, std::move(wrong)},
        });
    }
}

}  // namespace

void add_direct_pixels(Catalogue& catalogue) {
    add_values(catalogue);
    add_threads(catalogue);
    add_textures(catalogue);
    add_constant(catalogue);
}

}  // namespace plumb::suites
