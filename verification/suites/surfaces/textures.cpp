// Lookups against the functions that they stand for.

#include <cmath>
#include <numbers>

#include "scenes/scene.h"
#include "scenes/textures/texture.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {
namespace {

using description::Wrap;
using Lookup = std::function<double(double u, double v)>;

// ---- Bitmap

constexpr int width = 7, height = 5;

/// Bilinear interpolation has it exactly, between the outermost texel centres.
double saddle(double u, double v) {
    return 1 + 2 * u + 3 * v - 4 * u * v;
}

Texels picture_of_saddle() {
    Texels texels{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            texels.rgb.insert(texels.rgb.end(), 3, static_cast<float>(saddle((x + 0.5) / width, (y + 0.5) / height)));
    return texels;
}

double looked_up(double u, double v) {
    static const Texels texels = picture_of_saddle();
    return bilinear(texels, Wrap::repeat, u, v)[0];
}

Verdict is_saddle(const Lookup& lookup, const Run& run) {
    std::vector<BoundedCase> cases;
    RandomStream random = run.random(0);
    for (int i = 0; i < 4096; ++i) {
        const double u = (0.5 + (width - 1) * random.uniform()) / width;
        const double v = (0.5 + (height - 1) * random.uniform()) / height;
        const double column = static_cast<double>(random.below(7)) - 3, row = static_cast<double>(random.below(7)) - 3;
        const double found = lookup(u + column, v + row), truth = saddle(u, v);
        cases.push_back({fmt::format("({:.4f}, {:.4f}) + ({}, {}): {:.7g} for {:.7g}", u, v, column, row, found, truth),
                         std::abs(found - truth)});
    }
    return within_bound(cases, 1e-6, "of 1 to 4");  // texels are floats
}

// ---- Checkerboard

double board(double u, double v) {
    static const TextureLookup lookup(
        {.kind = description::Checkerboard{Spectrum::grey(1), Spectrum::grey(0)}, .to_uv = {}, .place = {}});
    return lookup.at(u, v)[0];
}

Verdict is_checkered(const Lookup& lookup, const Run& run) {
    std::uint64_t wrong = 0, points = 0;
    RandomStream random = run.random(0);
    for (; points < 4096; ++points) {
        const double u = 8 * random.uniform() - 4, v = 8 * random.uniform() - 4;
        const bool first = std::sin(2 * std::numbers::pi * u) * std::sin(2 * std::numbers::pi * v) > 0;
        wrong += lookup(u, v) != (first ? 1 : 0);
    }
    return exactly(wrong == 0, points, fmt::format("{} of {} points have the other colour", wrong, points));
}

// ---- Mask

/// What passes two plates of these opacities: of rays that choose by u, and of light to a point behind them.
struct Passed {
    double rays, light;
};
using Plates = std::function<Passed(double first, double second)>;
constexpr int lattice = 4096;

Passed through_plates(double first, double second) {
    description::Scene plates;
    plates.materials.push_back({.kind = description::Diffuse{}, .id = {}, .place = {}});
    for (const auto& [opacity, z] : {std::pair{first, 1.}, {second, 2.}}) {
        const description::MaterialId material{static_cast<std::uint32_t>(plates.materials.size())};
        plates.materials.push_back({.kind = description::Mask{Spectrum::grey(opacity), {0}}, .id = {}, .place = {}});
        plates.shapes.push_back({.geometry = transformed(rectangle_mesh(), Transform::translate({0, 0, z})),
                                 .material = material,
                                 .emitter = {},
                                 .id = {},
                                 .place = {}});
    }
    const Scene scene(std::move(plates));
    const SurfacePoint from = disk_point({0.1, 0.2, 0}, {0, 0, 1}, 1);
    RayLog rays;
    std::uint64_t passed = 0;
    for (int i = 0; i < lattice; ++i) passed += !scene.intersect(leave(from, {0, 0, 1}), (i + 0.5) / lattice, rays);
    LightSample sample;
    sample.direction = {0, 0, 1};
    sample.distance = HUGE_VAL;
    return {static_cast<double>(passed) / lattice, scene.transmittance(from, sample, rays)};
}

Verdict pass_alike(const Plates& plates) {
    std::vector<BoundedCase> cases;
    for (const double first : {0.0, 0.3, 0.75, 1.0})
        for (const double second : {0.0, 0.2, 0.5, 1.0}) {
            const Passed passed = plates(first, second);
            const double truth = (1 - first) * (1 - second);
            const std::string name = fmt::format("opacities {} and {}", first, second);
            cases.push_back({name + ", rays", std::abs(passed.rays - truth)});
            cases.push_back({name + ", shadow rays, in thousandths", 1e3 * std::abs(passed.light - truth)});
        }
    return within_bound(cases, 1.0 / lattice, "of the light");
}

}  // namespace

void add_surfaces_textures(Catalogue& catalogue) {
    catalogue.add(
        {.id = "texture/bitmap/lookup",
         .statement = "Between its texels' centres, which lie at ((i + 1/2)/width, (j + 1/2)/height), a picture of a "
                      "bilinear function is that function, and repeats with period 1.",
         .source = "ours, scenes/textures/texture.h",
         .kind = Kind::bounded,
         .trial = {is_saddle,
                   looked_up,
                   {{"half-texel", "texels' corners are taken for their centres",
                     [](double u, double v) { return looked_up(u + 0.5 / width, v + 0.5 / height); }},
                    {"upside-down", "v grows upwards", [](double u, double v) { return looked_up(u, 1 - v); }},
                    {"nearest", "the nearest texel is taken",
                     [](double u, double v) {
                         return looked_up((std::floor(u * width) + 0.5) / width,
                                          (std::floor(v * height) + 0.5) / height);
                     }},
                    {"stretched", "the outermost centres are laid on the picture's edges", [](double u, double v) {
                         return looked_up((u * (width - 1) + 0.5) / width, (v * (height - 1) + 0.5) / height);
                     }}}}});
    catalogue.add(
        {.id = "texture/checkerboard/lookup",
         .statement = "A checkerboard has its first colour where sin 2πu sin 2πv is positive.",
         .source = "Mitsuba's checkerboard, whose squares have side 1/2",
         .kind = Kind::exact,
         .trial = {is_checkered,
                   board,
                   {{"swapped", "the colours are exchanged", [](double u, double v) { return 1 - board(u, v); }},
                    {"shifted", "the pattern is shifted by half a square",
                     [](double u, double v) { return board(u + 0.25, v + 0.25); }},
                    {"large", "squares have side 1", [](double u, double v) { return board(u / 2, v / 2); }}}}});
    catalogue.add({.id = "bsdf/mask/transmittance",
                   .statement = "Two masks of opacities a and b let (1 − a)(1 − b) of rays and of shadow rays through.",
                   .source = "ours, docs/scenes.md: a mask is part of visibility",
                   .kind = Kind::bounded,
                   .trial = {pass_alike,
                             through_plates,
                             {{"opacity-for-transparency", "a mask lets through its opacity",
                               [](double a, double b) { return through_plates(1 - a, 1 - b); }},
                              {"one-number-for-both", "a ray uses the same number for the second mask as for the first",
                               [](double a, double b) {
                                   return Passed{1 - std::max(a, b), (1 - a) * (1 - b)};
                               }},
                              {"shadows-of-opaque", "a mask stops every shadow ray", [](double a, double b) {
                                   return Passed{(1 - a) * (1 - b), a == 0 && b == 0 ? 1. : 0.};
                               }}}}});
}

}  // namespace plumb::suites
