// `plumb compare` on trial: honest renders, spoiled renders, and what it must leave undecided, without a renderer.

#include <fmt/format.h>

#include "core/srgb.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"
#include "verification/pictures/synthetic_render.h"
#include "verification/suites/comparison/compare_subjects.h"

namespace plumb::suites {
namespace {

using Colour = SyntheticRender::Colour;
using Truth = std::function<Colour(int, int)>;

// ---- a picture of 32x32: a wall, a disk, a lamp that is seen directly, and stripes

constexpr int edge = 32, box_samples = 8;

bool on_disk(double x, double y) {
    return std::hypot(x - 8, y - 22) < 6;
}
bool on_lamp(double x, double y) {
    return x >= 18 && x < 28 && y >= 2 && y < 8;
}

Colour radiance(double x, double y) {
    if (on_lamp(x, y)) return {6, 5, 4};
    if (on_disk(x, y)) return {0.6, 0.2, 0.1};
    if (x >= 16 && y >= 16) return std::fmod(x, 3) < 1.5 ? Colour{0.7, 0.7, 0.6} : Colour{0.15, 0.15, 0.2};
    return {0.3 + 0.01 * x, 0.4, 0.5 - 0.005 * y};
}

using Radiance = std::function<Colour(double, double)>;

/// Pixels as means over a square of this width about their centres, moved by `shift`.
Truth pixels_of(const Radiance& picture, double width = 1, double shift = 0) {
    std::vector<Colour> values(static_cast<std::size_t>(edge) * edge);
    for (int i = 0; i < edge * edge; ++i)
        for (int s = 0; s < box_samples * box_samples; ++s) {
            const auto place = [&](int pixel, int cell) {
                return pixel + 0.5 + shift + width * ((cell + 0.5) / box_samples - 0.5);
            };
            const Colour c = picture(place(i % edge, s % box_samples), place(i / edge, s / box_samples));
            for (std::size_t k = 0; k < 3; ++k)
                values[static_cast<std::size_t>(i)][k] += c[k] / (box_samples * box_samples);
        }
    return [values](int x, int y) { return values[static_cast<std::size_t>(y * edge + x)]; };
}

/// Samples spread by 60 % about their mean; a lamp that is seen directly has no noise.
double even_noise(RandomStream& random, int x, int y) {
    return on_lamp(x + 0.5, y + 0.5) ? 1 : 0.4 + 1.2 * random.uniform();
}

SyntheticRender render(const Truth& truth = pixels_of(radiance), int replicates = 16) {
    return {.width = edge, .height = edge, .replicates = replicates, .samples = 64, .truth = truth, .law = even_noise};
}

// ---- what is done to it

/// The mean of two renders of equal size.
Image joined(const Image& one, const Image& other) {
    Image both = one;
    for (std::size_t i = 0; i < both.values.size(); ++i)
        both.values[i] = (one.values[i] + other.values[i]) / (i % 6 < 3 ? 2 : 4);
    return both;
}

// ---- one comparison

Pair against(const std::function<Image(std::uint64_t)>& spoiled) {
    return [=](std::uint64_t seed) { return std::pair{render()(2 * seed), spoiled(2 * seed + 1)}; };
}

std::vector<Spoiled> spoiled_by_hand() {
    const auto change = [](const Change& how) {
        return against([=](std::uint64_t seed) { return changed(render()(seed), how); });
    };
    constexpr PixelBox lamp{18, 2, 10, 6};
    return {
        {"brighter", "1 % brighter.", change([](double v, int, int) { return 1.01 * v; })},
        {"dark-tile",
         "One tile 3 % darker.",
         change([](double v, int x, int y) { return v * (x >= 8 && x < 16 && y < 8 ? 0.97 : 1); }),
         {8, 0, 8, 8}},
        {"srgb-as-linear", "sRGB written as if it were linear.",
         change([](double v, int, int) { return srgb_from_linear(v); })},
        {"eight-bits", "Written in 8 bits and read again: the lamp is cut off.",
         against([](std::uint64_t seed) { return in_bytes(render()(seed)); }), lamp},
        {"blurred", "Blurred over 3x3 pixels.", against([](std::uint64_t seed) { return blurred(render()(seed)); })},
        {"seeds-overlap", "Half of the samples are those of the other image.", [](std::uint64_t seed) {
             const SyntheticRender half = render(pixels_of(radiance), 8);
             const Image shared = half(3 * seed);
             return std::pair{joined(shared, half(3 * seed + 1)), joined(shared, half(3 * seed + 2))};
         }}};
}

std::vector<Spoiled> spoiled_renders() {
    const auto seen = [](const Radiance& picture, double width = 1, double shift = 0) {
        return against([truth = pixels_of(picture, width, shift)](std::uint64_t seed) { return render(truth)(seed); });
    };
    const auto where = [](auto inside, double factor) {
        return [=](double x, double y) {
            Colour c = radiance(x, y);
            for (double& v : c) v *= inside(x, y) ? factor : 1;
            return c;
        };
    };
    const auto in_corner = [](double x, double y) { return x < 8 && y < 8; };
    SyntheticRender many = render(), spiky = render(), clamped = render();
    many.samples = 256;
    SyntheticRender light_missing = many;
    light_missing.law = [](RandomStream& random, int x, int y) {
        const double sample = even_noise(random, x, y);
        return x >= 16 && y >= 8 && random.uniform() < 0.01 ? 0 : sample;
    };
    spiky.law = spiky_noise(50, 10);
    clamped.law = [law = spiky.law](RandomStream& random, int x, int y) { return std::min(5.0, law(random, x, y)); };
    return {
        {"cosine-missing",
         "A disk without its cosine, which is between 0.8 and 1.",
         seen(where(on_disk, 1.1)),
         {2, 16, 12, 12}},
        {"depth-limited", "A corner without its indirect light, a tenth.", seen(where(in_corner, 0.9)), {0, 0, 8, 8}},
        {"half-pixel", "Half a pixel aside.", seen(radiance, 1, 0.5)},
        {"filter-width", "A filter of twice the width.", seen(radiance, 2)},
        {"light-missing",
         "A light of a part of the picture is left out in 1 % of the samples.",
         [=](std::uint64_t seed) {
             return std::pair{many(2 * seed), light_missing(2 * seed + 1)};
         },
         {16, 8, 16, 24}},
        {"fireflies-clamped", "Samples are cut off at five times the mean.", [=](std::uint64_t seed) {
             return std::pair{spiky(2 * seed), clamped(2 * seed + 1)};
         }}};
}

// ---- how often

/// Both sides' layers of variances are off by a factor.
TwoSides noisy_pair(const SyntheticRender& one, const SyntheticRender& other, double variance_scale,
                    RandomStream& random) {
    Image first = one(random.bits());
    return {with_variance(std::move(first), variance_scale), with_variance(other(random.bits()), variance_scale)};
}

SyntheticRender noisy(int replicates, const std::function<double(RandomStream&, int, int)>& law) {
    return {.width = edge,
            .height = edge,
            .replicates = replicates,
            .samples = 4,
            .truth = pixels_of(radiance),
            .law = law};
}

Verdict level_is_kept(int replicates, double variance_scale, const Run& run) {
    constexpr double alpha = 0.05;
    const SyntheticRender one = noisy(replicates, exponential_noise), other = noisy(16, even_noise);
    return mean_at_most(
        [&](RandomStream& random) {
            return is_refuted(noisy_pair(one, other, variance_scale, random), alpha) ? 1.0 : 0.0;
        },
        {.bound = alpha, .margin = 0.04, .bounds = {0, 1}, .cap = run.pick<std::uint64_t>(4000, 40000)}, run);
}

Verdict honest_pairs(double variance_scale, const Run& run) {
    const std::vector<SyntheticRender> renders{noisy(4, exponential_noise), noisy(16, exponential_noise),
                                               noisy(16, spiky_noise(2000, 400)), noisy(8, spiky_noise(50, 10))};
    return pairs_are_not_refuted(
        [&](std::uint64_t i, RandomStream& random) {
            const SyntheticRender& render = renders[i % renders.size()];
            return noisy_pair(render, render, variance_scale, random);
        },
        run);
}

// ---- fireflies

/// A pair of quiet renders, one of which was hit by a path of `size` times the mean in one replicate of sixteen; the
/// layer of variances knows of it or not.
Verdict one_firefly(double size, bool known, const Run& run) {
    RandomStream random = run.random(0);
    std::pair<Image, Image> images{render()(random.bits()), render()(random.bits())};
    const std::size_t pixel = static_cast<std::size_t>(10 * edge + 10) * 6;
    for (std::size_t c = 0; c < 3; ++c) {
        images.second.values[pixel + c] += static_cast<float>(size / 16);
        if (known) images.second.values[pixel + 3 + c] += static_cast<float>(size * size / 256);
    }
    return outcome_is(compared(images, run.alpha()).verdict, Outcome::undecided);
}

}  // namespace

void add_comparison_compare(Catalogue& catalogue) {
    std::vector<Spoiled> spoiled = spoiled_by_hand();
    for (Spoiled& render : spoiled_renders()) spoiled.push_back(std::move(render));
    const Pair honest = against([](std::uint64_t seed) { return render()(seed); });
    catalogue.add(
        {.id = "render/compare/spoiled",
         .statement = "Two honest renders are found equal; a spoiled one is refuted, at the place of the defect.",
         .source = "ours, docs/compare.md",
         .kind = Kind::mean,
         .trial = {[](const Compared& subject, const Run& run) { return comparison_shows(subject, run); },
                   {honest},
                   std::move(spoiled)}});
    catalogue.add(
        {.id = "render/compare/honest",
         .statement = "200 pairs of honest renders with skewed noise and fireflies are not refuted.",
         .source = "ours, docs/compare.md",
         .kind = Kind::mean,
         .trial = {
             honest_pairs, 1, {{"quarter-variance", "Layers of variances that are four times too small.", 0.25}}}});
    for (const int replicates : {2, 4})
        catalogue.add({.id = fmt::format("render/compare/level-{}-replicates", replicates),
                       .statement = fmt::format("Renders of {} replicates with skewed noise are refuted at most as "
                                                "often as alpha says.",
                                                replicates),
                       .source = "ours, docs/compare.md",
                       .kind = Kind::mean,
                       .trial = {[=](double variance_scale, const Run& run) {
                                     return level_is_kept(replicates, variance_scale, run);
                                 },
                                 1,
                                 {{"tenth-variance", "Layers of variances that are ten times too small.", 0.1}}}});
    catalogue.add({.id = "render/compare/firefly",
                   .statement = "One firefly in one of two images leaves them undecided.",
                   .source = "ours, docs/compare.md",
                   .kind = Kind::mean,
                   .trial = {[](bool known, const Run& run) { return one_firefly(1600, known, run); },
                             true,
                             {{"unknown", "The layer of variances does not know of it.", false}}}});
}

}  // namespace plumb::suites
