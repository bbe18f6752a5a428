#include "verification/pictures/image_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/moments.h"
#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

/// Parts of alpha.
constexpr double tiles_part = 1.0 / 2, chi_square_part = 1.0 / 6, means_part = 1.0 / 6, alike_part = 1.0 / 6;

void require_alike(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height)
        throw Error(fmt::format("image a is {}x{} pixels, image b {}x{}", a.width, a.height, b.width, b.height));
    if (a.channels != b.channels) throw Error("images a and b have different channels");
}

// ---- tiles

/// A grid of boxes with their sums, channel by channel.
struct Grid {
    int tile, columns, rows;
    std::size_t channels;
    std::vector<PixelBox> boxes;       // row by row
    std::vector<DifferenceSums> sums;  // box by box, channel by channel

    [[nodiscard]] const DifferenceSums& at(int column, int row, std::size_t channel) const {
        return sums[static_cast<std::size_t>(row * columns + column) * channels + channel];
    }
    /// The sums of the box and its up to eight neighbours.
    [[nodiscard]] DifferenceSums around(int column, int row, std::size_t channel) const {
        DifferenceSums total;
        for (int v = std::max(0, row - 1); v <= std::min(rows - 1, row + 1); ++v)
            for (int u = std::max(0, column - 1); u <= std::min(columns - 1, column + 1); ++u)
                total.merge(at(u, v, channel));
        return total;
    }
    [[nodiscard]] DifferenceSums total(std::size_t channel) const {
        DifferenceSums all;
        for (std::size_t i = channel; i < sums.size(); i += channels) all.merge(sums[i]);
        return all;
    }
};

int tile_edge(const Picture& a, int asked, const Correlation& correlation) {
    const int largest = std::min(a.width, a.height);
    if (asked > 0) return std::min(asked, largest);
    const double edge = std::sqrt(static_cast<double>(a.width) * a.height / 256);
    return std::min(largest, std::max({8, static_cast<int>(edge), 4 * correlation.reach}));
}

Grid grid_of(const Picture& a, const Picture& b, int tile) {
    Grid grid{tile, std::max(1, a.width / tile), std::max(1, a.height / tile), a.channels.size(), {}, {}};
    const auto edge = [](int i, int parts, int length) {
        return static_cast<int>(static_cast<std::int64_t>(i) * length / parts);
    };
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const int x = edge(column, grid.columns, a.width), y = edge(row, grid.rows, a.height);
            grid.boxes.push_back(
                {x, y, edge(column + 1, grid.columns, a.width) - x, edge(row + 1, grid.rows, a.height) - y});
            for (std::size_t c = 0; c < grid.channels; ++c) grid.sums.push_back(sums_of(a, b, grid.boxes.back(), c));
        }
    return grid;
}

// ---- what a difference says, before it is known which differ

// One side has errors and the other shows none: what it cannot have seen is unknown.
bool one_side_unknown(const DifferenceSums& sums, const DifferenceRules& rules) {
    const bool a = sums.variance_a == 0, b = sums.variance_b == 0;
    return a != b && !std::isinf(a ? rules.degrees_a : rules.degrees_b);
}

TileState state_of(const DifferenceSums& sums, const MeanDifference& found, const DifferenceRules& rules,
                   double level) {
    if (one_side_unknown(sums, rules)) return TileState::no_variance;
    if (found.interval.inside({-rules.delta, rules.delta}) && interval_is_trusted(found, rules.beta))
        return TileState::same;
    // What only skewness keeps from being a difference, or from being none.
    const bool skewed = normal_two_sided_tail(found.z) < level || !interval_is_trusted(found, rules.beta);
    return skewed ? TileState::heavy_tails : TileState::too_noisy;
}

bool may_differ(const TileTest& tile) {
    return tile.state != TileState::no_pixels && tile.state != TileState::no_variance;
}

TileTest tile_test(const Grid& grid, int column, int row, std::size_t channel, const DifferenceRules& rules,
                   double level) {
    const DifferenceSums& sums = grid.at(column, row, channel);
    TileTest test{.box = grid.boxes[static_cast<std::size_t>(row * grid.columns + column)], .channel = channel};
    test.pixels = sums.pixels;
    if (sums.pixels == 0) return test;
    test.found = difference_of(sums, grid.around(column, row, channel), rules);
    test.state = state_of(sums, test.found, rules, level);
    return test;
}

// Holm's: the smallest p-value at level/m, the next at level/(m − 1), until one is larger.
std::vector<std::size_t> refuted_tiles(const std::vector<TileTest>& tiles, double level) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < tiles.size(); ++i)
        if (may_differ(tiles[i])) order.push_back(i);
    std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) {
        const MeanDifference &p = tiles[i].found, &q = tiles[j].found;
        if (p.p_value != q.p_value) return p.p_value < q.p_value;
        return std::abs(p.difference) * q.standard_error > std::abs(q.difference) * p.standard_error;
    });
    std::size_t count = 0;
    while (count < order.size() &&
           tiles[order[count]].found.p_value <= level / static_cast<double>(order.size() - count))
        ++count;
    order.resize(count);
    return order;
}

std::vector<std::size_t> undecided_tiles(const std::vector<TileTest>& tiles) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < tiles.size(); ++i)
        if (tiles[i].state != TileState::same && tiles[i].state != TileState::differs) order.push_back(i);
    const auto excess = [&](std::size_t i) {
        const MeanDifference& found = tiles[i].found;
        return std::max(-found.interval.low, found.interval.high) / found.delta;
    };
    std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) { return excess(i) > excess(j); });
    return order;
}

// ---- the picture

// Normal scores of tiles: smaller ones for the upper tail where tails are heavy, raw ones for the lower tail.
void add_chi_square(ChannelTest& test, const std::vector<TileTest>& tiles, std::size_t channel) {
    double cautious = 0;
    for (const TileTest& tile : tiles) {
        if (tile.channel != channel || !may_differ(tile) || !(tile.found.standard_error > 0)) continue;
        const double p = std::max(1e-300, tile.found.p_value);
        cautious += p < 1 ? std::pow(normal_upper_quantile(p / 2), 2) : 0;
        test.chi_square += tile.found.z * tile.found.z;
        ++test.degrees;
    }
    if (test.degrees == 0) return;
    const auto degrees = static_cast<double>(test.degrees);
    test.upper_p = chi_square_tail(cautious, degrees);
    test.lower_p = chi_square_lower_tail(test.chi_square, degrees);
}

// ---- too alike

// t² = d²/(va + vb), of ν degrees of freedom, as t² (ν + 1)/(ν + t²): at most ν + 1, whatever spikes there are, with
// expectation 1 for normal errors and for any whose difference is as likely to have the other sign [Efron 1969], and
// more for others. Empty where rounding may hide what noise there is: equal constants say nothing, and the variance
// that a renderer found for them is what rounding left of it.
std::optional<double> bounded_square(double a, double b, double rounding, double variance, double per_degree) {
    const double size = std::abs(a) + std::abs(b), hidden = rounding * size;
    const double told_from_constants = std::max(8 * hidden, 5e-5 * size);
    if (std::abs(a - b) <= hidden && variance <= told_from_constants * told_from_constants) return {};
    const double square = (a - b) * (a - b), whole = variance + square * per_degree;
    if (!(whole > 0) || !std::isfinite(whole)) return {};
    return square * (1 + per_degree) / whole;
}

// 1/ν of va + vb [Satterthwaite 1946], at the most balanced of the middle half of a tile's shares va/(va + vb): its
// spikes have most of the variance, but are few of the pixels. Where ν is too large, squares are too.
double per_degree_in(const Picture& a, const Picture& b, const PixelBox& box, std::size_t channel) {
    std::vector<double> shares;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            const std::size_t k = a.at(x, y, channel);
            if (const double both = a.variance[k] + b.variance[k]; both > 0) shares.push_back(a.variance[k] / both);
        }
    double share = std::isinf(b.degrees) ? 0 : std::isinf(a.degrees) ? 1 : a.degrees / (a.degrees + b.degrees);
    if (!shares.empty()) {
        const auto quarter = static_cast<std::ptrdiff_t>(shares.size() / 4);
        std::ranges::sort(shares);
        share = std::clamp(share, *(shares.begin() + quarter), *(shares.end() - 1 - quarter));
    }
    return share * share / a.degrees + (1 - share) * (1 - share) / b.degrees;
}

/// The test of how far the mean of those squares is below 1. Each pixel is the mean of its channels. Their variance is
/// taken for no less than that of normal errors of one channel: samples that are shared have less, and equal images
/// none.
AlikenessTest alikeness(const Picture& a, const Picture& b, const Grid& grid, const DifferenceRules& rules) {
    Moments excess, normal_variance;
    std::vector<double> per_degree(grid.channels);
    for (const PixelBox& box : grid.boxes) {
        for (std::size_t c = 0; c < grid.channels; ++c) per_degree[c] = per_degree_in(a, b, box, c);
        for (int y = box.y; y < box.y + box.height; ++y)
            for (int x = box.x; x < box.x + box.width; ++x) {
                Moments channels;
                for (std::size_t c = 0; c < grid.channels; ++c) {
                    const std::size_t k = a.at(x, y, c);
                    if (const auto square = bounded_square(a.mean[k], b.mean[k], rules.rounding,
                                                           a.variance[k] + b.variance[k], per_degree[c]))
                        channels.add(*square - 1);
                }
                if (channels.count() == 0) continue;
                excess.add(channels.mean());
                normal_variance.add(2 / (1 + 3 * per_degree[0]));
            }
    }
    if (excess.count() < 2) return {};
    const auto n = static_cast<double>(excess.count());
    const double t =
        excess.mean() / std::sqrt(std::max(excess.variance(), normal_variance.mean()) * rules.inflation / n);
    const double of_pixels = excess.variance() > 0 ? std::abs(excess.skewness()) : 0;
    const double skewness = (of_pixels + 2 * std::sqrt(6 / n)) * std::sqrt(rules.inflation / n);
    return {1 + excess.mean(), t < 0 ? std::min(1.0, skewed_p_value(t, skewness) / 2) : 1.0};
}

// ---- words

std::string place(const ImageComparison& found, const TileTest& tile) {
    return fmt::format("the {}x{} pixels at ({}, {}), channel {}", tile.box.width, tile.box.height, tile.box.x,
                       tile.box.y, found.channels[tile.channel].channel);
}

std::string relative(const MeanDifference& found) {
    if (found.b == 0) return fmt::format("a is {:.3g}, b is 0", found.a);
    return fmt::format("a is {:+.3g} % of b away, {:.1f} standard errors", 100 * found.difference / std::abs(found.b),
                       std::abs(found.difference) / found.standard_error);
}

std::string refutation(const ImageComparison& found, const ComparisonSettings& settings) {
    std::vector<std::string> parts;
    if (!found.differing.empty()) {
        const TileTest& worst = found.tiles[found.differing.front()];
        parts.push_back(fmt::format("{} of {} tile means differ, most of all {}: {}", found.differing.size(),
                                    found.tiles.size(), place(found, worst), relative(worst.found)));
    }
    const auto channels = static_cast<double>(found.channels.size());
    for (const ChannelTest& channel : found.channels) {
        if (channel.state == TileState::differs)
            parts.push_back(
                fmt::format("the picture's mean of {} differs: {}", channel.channel, relative(channel.mean)));
        if (channel.upper_p < settings.alpha * chi_square_part / 2 / channels)
            parts.push_back(fmt::format("the tiles of {} differ together: chi-square {:.4g} of {} degrees of freedom",
                                        channel.channel, channel.chi_square, channel.degrees));
        if (channel.lower_p < settings.alpha * chi_square_part / 2 / channels)
            parts.push_back(
                fmt::format("the tiles of {} are too alike for independent errors: chi-square {:.4g} of {} "
                            "degrees of freedom",
                            channel.channel, channel.chi_square, channel.degrees));
    }
    if (found.alike.p_value < settings.alpha * alike_part)
        parts.push_back(
            fmt::format("pixels are too alike for independent errors: their squared t, bounded, is {:.3g} in the mean, "
                        "not 1 or more; do the images share samples?",
                        found.alike.ratio));
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
    return text;
}

std::string doubt(const ImageComparison& found) {
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
    if (found.bad_a + found.bad_b > 0)
        add(fmt::format("{} pixels of a and {} of b are no finite numbers and were not compared", found.bad_a,
                        found.bad_b));
    for (const ChannelTest& channel : found.channels)
        if (channel.state != TileState::same)
            add(fmt::format("the picture's mean of {} is not decided ({})", channel.channel, to_string(channel.state)));
    if (!found.undecided.empty()) {
        const TileTest& worst = found.tiles[found.undecided.front()];
        add(fmt::format("{} of {} tile means are not decided, least of all {} ({})", found.undecided.size(),
                        found.tiles.size(), place(found, worst), to_string(worst.state)));
    }
    return text;
}

Verdict verdict_of(const ImageComparison& found, const ComparisonSettings& settings) {
    Verdict verdict;
    for (const TileTest& tile : found.tiles) {
        if (tile.channel == 0) verdict.samples += tile.pixels;
        if (!may_differ(tile)) continue;
        verdict.statistic = std::fmax(verdict.statistic, std::abs(tile.found.z));
        verdict.p_value = std::fmin(verdict.p_value, tile.found.p_value);
    }
    verdict.resolution = settings.delta;
    const MeanDifference& worst =
        std::ranges::max(found.channels, {}, [](const ChannelTest& c) { return std::abs(c.mean.z); }).mean;
    if (worst.b != 0)
        verdict.deviation = {worst.interval.low / std::abs(worst.b), worst.interval.high / std::abs(worst.b)};
    verdict.reason = refutation(found, settings);
    verdict.outcome = Outcome::refuted;
    if (verdict.reason.empty()) {
        verdict.reason = doubt(found);
        verdict.outcome = Outcome::undecided;
    }
    if (verdict.reason.empty()) {
        verdict.outcome = Outcome::holds;
        verdict.reason = fmt::format("every channel's mean is equal within {:.3g} %, every tile's within {:.3g} %",
                                     100 * settings.delta, 100 * settings.tile_delta);
    }
    verdict.evidence = {{"tile", static_cast<std::uint64_t>(found.tile)},
                        {"tile_means", static_cast<std::uint64_t>(found.tiles.size())},
                        {"differing", static_cast<std::uint64_t>(found.differing.size())},
                        {"undecided", static_cast<std::uint64_t>(found.undecided.size())},
                        {"mean_bounded_squared_t", found.alike.ratio},
                        {"variance_inflation", found.correlation.inflation}};
    return verdict;
}

}  // namespace

std::string to_string(TileState state) {
    switch (state) {
        case TileState::same: return "same";
        case TileState::differs: return "differs";
        case TileState::too_noisy: return "too noisy";
        case TileState::heavy_tails: return "heavy tails";
        case TileState::no_variance: return "one side shows no variance";
        case TileState::poorly_known: return "its known value is less certain than delta";
        case TileState::no_pixels: return "no finite pixels";
    }
    return "";
}

ImageComparison compare(const Picture& a, const Picture& b, const ComparisonSettings& settings) {
    require_alike(a, b);
    ImageComparison found{.bad_a = a.bad_pixels, .bad_b = b.bad_pixels};
    found.correlation = correlation_of(a, b);
    const Grid grid = grid_of(a, b, tile_edge(a, settings.tile, found.correlation));
    found.tile = grid.tile;
    found.columns = grid.columns;
    found.rows = grid.rows;
    const double tests = static_cast<double>(grid.sums.size()), channels = static_cast<double>(grid.channels);
    DifferenceRules rules{.degrees_a = a.degrees,
                          .degrees_b = b.degrees,
                          .inflation = std::max(1.0, found.correlation.inflation),
                          .rounding = std::max(a.rounding, b.rounding),
                          .beta = settings.beta};

    std::vector<double> spikes;
    for (std::size_t c = 0; c < grid.channels; ++c) spikes.push_back(largest_spike(a, b, c));
    for (std::size_t c = 0; c < grid.channels; ++c) {
        const DifferenceSums all = grid.total(c);
        rules.spike = spikes[c];
        ChannelTest test{.channel = a.channels[c]};
        if (all.pixels > 0) {
            rules.delta = settings.delta * std::abs(all.b) / static_cast<double>(all.pixels);
            const double level = settings.alpha * means_part / channels;
            test.mean = difference_of(all, all, rules);
            test.state = state_of(all, test.mean, rules, level);
            if (test.state != TileState::no_variance && test.mean.p_value < level) test.state = TileState::differs;
        }
        found.channels.push_back(test);
    }
    const double level = settings.alpha * tiles_part;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            for (std::size_t c = 0; c < grid.channels; ++c) {
                const DifferenceSums& sums = grid.at(column, row, c);
                rules.spike = spikes[c];
                const double own = sums.pixels > 0 ? std::abs(sums.b) / static_cast<double>(sums.pixels) : 0;
                rules.delta =
                    settings.tile_delta * std::max(own, settings.tile_floor * std::abs(found.channels[c].mean.b));
                found.tiles.push_back(tile_test(grid, column, row, c, rules, level / tests));
            }
    found.differing = refuted_tiles(found.tiles, level);
    for (const std::size_t i : found.differing) found.tiles[i].state = TileState::differs;
    found.undecided = undecided_tiles(found.tiles);
    for (std::size_t c = 0; c < grid.channels; ++c) add_chi_square(found.channels[c], found.tiles, c);
    found.alike = alikeness(a, b, grid, rules);
    found.errors = errors_of(a, b, rules.inflation);
    found.verdict = verdict_of(found, settings);
    return found;
}

}  // namespace plumb
