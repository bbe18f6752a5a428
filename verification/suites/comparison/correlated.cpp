// `plumb compare` on trial with pictures whose pixels are not independent, or are rounded: how often are honest ones
// refuted, and are wrong ones still found?

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "verification/claim.h"
#include "verification/evidence/distributions.h"
#include "verification/pictures/synthetic_render.h"
#include "verification/suites/comparison/compare_subjects.h"

namespace plumb::suites {
namespace {

constexpr int edge = 64;

// ---- pictures of one channel

/// What errors of neighbours have in common: each is spread over its neighbours with the weights of a tent of radius 2,
/// or loses the mean of those about it, as blue noise does.
enum class Neighbours { independent, filtered, filtered_in_half, opposed };

using Law = double (*)(RandomStream&);
double exponential(RandomStream& random) {
    return -std::log1p(-random.uniform()) - 1;
}
double uniform(RandomStream& random) {
    return std::sqrt(3) * (2 * random.uniform() - 1);
}
/// One in 500 is 50 times the size.
double spiky(RandomStream& random) {
    constexpr double rarity = 500, size = 50, rest = (1 - size / rarity) / (1 - 1 / rarity);
    return (random.uniform() * rarity < 1 ? size : rest * (exponential(random) + 1)) - 1;
}

struct Side {
    Neighbours neighbours = Neighbours::independent;
    double noise = 1;  ///< standard deviation of an error before it is spread, over the truth's size
    int renders = 4;   ///< of one: with a layer of its variance, from four replicates
    Law law = exponential;
};

using Plane = std::vector<double>;
std::size_t at(int x, int y) {
    return static_cast<std::size_t>(((y + edge) % edge) * edge + (x + edge) % edge);
}

/// A wall that is lit unevenly, with dark windows.
double truth(double x, double y) {
    const double wall = 0.5 + 0.3 * std::sin(0.11 * x) + 0.2 * std::cos(0.07 * y);
    return std::fmod(x, 16) < 4 && std::fmod(y, 20) < 7 ? 0.3 * wall : wall;
}

/// Sums over 3x3 pixels with weights that are products of these.
Plane spread(const Plane& plane, const std::array<double, 3>& weights) {
    Plane result(plane.size());
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
            for (int v = -1; v <= 1; ++v)
                for (int u = -1; u <= 1; ++u)
                    result[at(x, y)] += weights[static_cast<std::size_t>(u + 1)] *
                                        weights[static_cast<std::size_t>(v + 1)] * plane[at(x + u, y + v)];
    return result;
}

Plane errors_of(const Side& side, RandomStream& random) {
    Plane own(edge * edge);
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) own[at(x, y)] = truth(x, y) * side.noise * side.law(random);
    if (side.neighbours == Neighbours::independent) return own;
    if (side.neighbours == Neighbours::opposed) {
        const Plane means = spread(own, {1. / 3, 1. / 3, 1. / 3});
        for (std::size_t i = 0; i < own.size(); ++i) own[i] -= 0.9 * means[i];
        return own;
    }
    Plane filtered = spread(own, {0.25, 0.5, 0.25});
    for (int y = 0; side.neighbours == Neighbours::filtered_in_half && y < edge; ++y)
        for (int x = 0; x < edge / 2; ++x) filtered[at(x, y)] = own[at(x, y)];
    return filtered;
}

/// Made of the errors and the place.
using Seen = std::function<double(double error, int x, int y)>;
double honestly(double error, int x, int y) {
    return truth(x, y) + error;
}

Image image_of(const Side& side, const Seen& seen, RandomStream& random) {
    const int replicates = side.renders > 1 ? 1 : 4;
    Plane sum(edge * edge), squares(edge * edge);
    for (int r = 0; r < replicates; ++r) {
        const Plane errors = errors_of(side, random);
        for (std::size_t i = 0; i < errors.size(); ++i) {
            sum[i] += errors[i];
            squares[i] += errors[i] * errors[i];
        }
    }
    Image image{edge, edge, {"Y"}, {}};
    if (replicates > 1) image.channels.emplace_back("variance.Y"), image.metadata = {{"plumb:replicates", "4"}};
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) {
            const double n = replicates, mean = sum[at(x, y)] / n;
            image.values.push_back(static_cast<float>(seen(mean, x, y)));
            if (replicates > 1)
                image.values.push_back(static_cast<float>((squares[at(x, y)] - n * mean * mean) / (n - 1) / n));
        }
    return image;
}

Renders renders_of(const Side& side, RandomStream& random, const Seen& seen = honestly) {
    std::vector<Image> images;
    for (int i = 0; i < side.renders; ++i) images.push_back(image_of(side, seen, random));
    return images;
}

Picture picture(const Renders& renders) {
    return picture_of(renders.images, std::vector<std::string>(renders.images.size(), "render"));
}

// ---- how often

/// Whether two pictures are refuted at a level, by some comparison.
using Judge = std::function<bool(const Picture& a, const Picture& b, double alpha)>;

bool compared_as_plumb_does(const Picture& a, const Picture& b, double alpha) {
    return compare(a, b, {.alpha = alpha}).verdict.outcome == Outcome::refuted;
}

/// Both tails of the tiles' chi-square, with one inflation for both sides and all of the picture.
bool compared_with_one_inflation(const Picture& a, const Picture& b, double alpha) {
    const double inflation = std::max(1.0, correlation_of(a, b).inflation);
    const PixelGrid grid = grid_of(a.width, a.height, 8);
    double chi_square = 0;
    for (const PixelBox& box : grid.boxes) {
        const DifferenceSums sums = sums_of(a, b, box, 0);
        DifferenceRules rules{.degrees_a = a.degrees, .degrees_b = b.degrees};
        rules.inflation = {.a = inflation, .b = inflation};
        chi_square += std::pow(difference_of(sums, sums, rules).z, 2);
    }
    const auto tiles = static_cast<double>(grid.boxes.size());
    return std::min(chi_square_tail(chi_square, tiles), chi_square_lower_tail(chi_square, tiles)) < alpha / 12;
}

/// Tiles that agree better than their pixels' variances say refute.
bool compared_with_a_lower_tail(const Picture& a, const Picture& b, double alpha) {
    return compare(a, b, {.alpha = alpha}).channels[0].lower_p < alpha / 12;
}

Verdict honest_pairs(const Judge& judge, const Run& run) {
    using enum Neighbours;
    static const std::vector<std::pair<Side, Side>> laws{{{independent, 3}, {filtered}},
                                                         {{independent, 1, 2}, {filtered_in_half, 2, 2}},
                                                         {{opposed, 1, 1}, {opposed, 1, 1}},
                                                         {{opposed}, {independent, 0.5}},
                                                         {{filtered, 1, 4, spiky}, {independent, 1, 4, spiky}},
                                                         {{filtered_in_half, 1, 1}, {independent, 0.5, 1}}};
    constexpr double alpha = 1e-5, most = 0.05;
    const auto pairs = run.pick<std::uint64_t>(96, 1920);
    std::uint64_t refuted = 0, judged = 0;
    while (judged < pairs && clopper_pearson(refuted, pairs, run.alpha()).low <= alpha) {
        RandomStream random = run.random(judged);
        const auto& [one, other] = laws[judged++ % laws.size()];
        const Picture a = picture(renders_of(one, random)), b = picture(renders_of(other, random));
        refuted += judge(a, b, alpha);
    }
    const double low = clopper_pearson(refuted, pairs, run.alpha()).low,
                 high = clopper_pearson(refuted, pairs, run.beta()).high;
    Verdict verdict;
    verdict.samples = judged;
    verdict.deviation = {low, high};
    verdict.resolution = most;
    verdict.outcome = low > alpha ? Outcome::refuted : high < most ? Outcome::holds : Outcome::undecided;
    verdict.reason = fmt::format("{} of {} honest pairs refuted at {} each", refuted, judged, alpha);
    return verdict;
}

// ---- power

/// Four renders of each side without layers; the errors of one side are spread by a filter.
struct Four {
    Seen seen = honestly;
    bool blurred = false, shared = false;
};

Image blurred_image(const Image& image) {
    Plane plane(image.values.begin(), image.values.end());
    plane = spread(plane, {1. / 3, 1. / 3, 1. / 3});
    Image out = image;
    std::ranges::transform(plane, out.values.begin(), [](double v) { return static_cast<float>(v); });
    return out;
}

Verdict four_are_told_apart(const Four& subject, const Run& run) {
    RandomStream random = run.random(0);
    constexpr double noise = 0.08;
    const Renders a = renders_of({Neighbours::filtered, noise, 4, uniform}, random);
    Renders b = renders_of({Neighbours::independent, noise, 4, uniform}, random, subject.seen);
    for (std::size_t i = 0; i < b.images.size(); ++i) {
        if (subject.blurred) b.images[i] = blurred_image(b.images[i]);
        if (subject.shared) b.images[i] = a.images[i];
    }
    return compare(picture(a), picture(b), {.alpha = run.alpha(), .delta = 0.05, .tile_delta = 0.5, .tile = 32})
        .verdict;
}

// ---- rounding

Image in_halves(Image image) {
    for (float& value : image.values) {
        int exponent = 0;
        (void)std::frexp(value, &exponent);
        exponent = std::max(exponent, -13);  // halves below 2^-14 are multiples of 2^-24
        value = std::ldexp(std::round(std::ldexp(value, 11 - exponent)), exponent - 11);
    }
    return image;
}

/// Renders whose noise is far below a half's last place to well above it; whether the comparison knows of halves.
Verdict halves_are_not_refuted(bool known, const Run& run) {
    std::uint64_t refuted = 0, pairs = 0;
    const auto with = [&](const Side& side, RandomStream& random) {
        Picture found = picture(in_halves(image_of(side, honestly, random)));
        if (!known) found.rounding = found.least_rounding = found.variance_rounding = 0;
        return found;
    };
    for (const double noise : {1e-4, 4e-4, 1.6e-3, 6.4e-3, 2.5e-2, 0.1})
        for (int i = 0; i < run.pick(4, 40); ++i) {
            RandomStream random = run.random(pairs++);
            const Side side{Neighbours::independent, noise, 1};
            const Picture a = with(side, random), b = with(side, random);
            refuted += compared_as_plumb_does(a, b, 1e-5);
        }
    Verdict verdict;
    verdict.samples = pairs;
    const double low = clopper_pearson(refuted, pairs, run.alpha()).low;
    verdict.deviation = {low, clopper_pearson(refuted, pairs, run.beta()).high};
    verdict.resolution = run.pick(0.2, 0.02);
    verdict.outcome = low > 1e-5                                    ? Outcome::refuted
                      : verdict.deviation.high < verdict.resolution ? Outcome::holds
                                                                    : Outcome::undecided;
    verdict.reason = fmt::format("{} of {} pairs in half floats refuted at 1e-5 each", refuted, pairs);
    return verdict;
}

}  // namespace

void add_comparison_correlated(Catalogue& catalogue) {
    catalogue.add(
        {.id = "calibration/pictures/correlated",
         .statement = "Honest pictures are not refuted where one side's pixels are correlated and the other's are not, "
                      "in one region more than in another, or have errors that cancel.",
         .source = "ours, docs/compare.md",
         .kind = Kind::mean,
         .trial = {honest_pairs,
                   Judge(compared_as_plumb_does),
                   {{"one-inflation", "One inflation for both sides and all of the picture, and both tails of tiles.",
                     Judge(compared_with_one_inflation)},
                    {"lower-tail", "Tiles that agree better than independent pixels would refute.",
                     Judge(compared_with_a_lower_tail)}}}});
    const auto darker = [](double error, int x, int y) {
        return (truth(x, y) + error) * (x >= 32 && y >= 32 ? 0.95 : 1);
    };
    catalogue.add(
        {.id = "render/compare/four",
         .statement = "Four renders of each side, one side filtered, are found equal; wrong ones are refuted.",
         .source = "ours, docs/compare.md",
         .kind = Kind::mean,
         .trial = {four_are_told_apart,
                   Four{},
                   {{"blurred", "Blurred over 3x3 pixels.", Four{.blurred = true}},
                    {"brighter", "4 % brighter.",
                     Four{[](double error, int x, int y) { return 1.04 * (truth(x, y) + error); }}},
                    {"dark-tile", "One tile of four 5 % darker.", Four{darker}},
                    {"half-pixel", "Half a pixel aside.",
                     Four{[](double error, int x, int y) { return truth(x + 0.5, y) + error; }}},
                    {"same-seeds", "The other side's renders again.", Four{.shared = true}}}}});
    catalogue.add({.id = "calibration/pictures/halves",
                   .statement = "Honest pictures are not refuted for having been rounded to half floats.",
                   .source = "ours, docs/compare.md",
                   .kind = Kind::mean,
                   .trial = {halves_are_not_refuted,
                             true,
                             {{"rounding-unknown", "The comparison takes halves for what was estimated.", false}}}});
}

}  // namespace plumb::suites
