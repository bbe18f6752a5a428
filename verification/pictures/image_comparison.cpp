#include "verification/pictures/image_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/moments.h"
#include "verification/evidence/distributions.h"
#include "verification/evidence/f_distribution.h"
#include "verification/pictures/comparison_verdict.h"
#include "verification/pictures/picture_copies.h"
#include "verification/pictures/samples_needed.h"

namespace plumb {
namespace {

void require_alike(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height)
        throw Error(fmt::format("image a is {}x{} pixels, image b {}x{}", a.width, a.height, b.width, b.height));
    if (a.channels != b.channels) throw Error("images a and b have different channels");
}

// ---- tiles

/// A grid of tiles with their sums, channel by channel, and what is known of these sums.
struct Grid {
    PixelGrid tiles;
    std::size_t channels;
    std::vector<DifferenceSums> sums;    // box by box, channel by channel
    std::vector<DifferenceSums> totals;  // channel by channel
    SumInflations inflations;

    [[nodiscard]] const DifferenceSums& at(std::size_t tile, std::size_t channel) const {
        return sums[tile * channels + channel];
    }
    /// The sums of the tile and its up to eight neighbours.
    [[nodiscard]] DifferenceSums around(int column, int row, std::size_t channel) const {
        DifferenceSums total;
        for_tiles_about(tiles, column, row, 1, [&](std::size_t tile) { total.merge(at(tile, channel)); });
        return total;
    }
};

int tile_edge(const Picture& a, int asked, const Correlation& correlation) {
    const int largest = std::min(a.width, a.height);
    if (asked > 0) return std::min(asked, largest);
    const double edge = std::sqrt(static_cast<double>(a.width) * a.height / 256);
    return std::min(largest, std::max({8, static_cast<int>(edge), 4 * correlation.reach}));
}

Grid summed(const Picture& a, const Picture& b, int tile, const Correlation& correlation) {
    Grid grid{grid_of(a.width, a.height, tile), a.channels.size(), {}, {}, {}};
    for (const PixelBox& box : grid.tiles.boxes)
        for (std::size_t c = 0; c < grid.channels; ++c) grid.sums.push_back(sums_of(a, b, box, c));
    grid.totals.resize(grid.channels);
    for (std::size_t i = 0; i < grid.sums.size(); ++i) grid.totals[i % grid.channels].merge(grid.sums[i]);
    grid.inflations = inflations_of(a, b, grid.tiles, correlation);
    return grid;
}

// ---- what a difference says, before it is known which differ

// One side has errors and the other shows none: what it cannot have seen is unknown.
bool one_side_unknown(const DifferenceSums& sums, const DifferenceRules& rules) {
    const bool a = sums.shown_a == 0, b = sums.shown_b == 0;
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

void forecast(MeanDifference& found, TileState state, const DifferenceRules& rules, double level) {
    if (state == TileState::too_noisy || state == TileState::heavy_tails)
        found.more_samples = more_samples(found, rules.epsilon, level, rules.beta);
}

TileTest tile_test(const Grid& grid, int column, int row, std::size_t channel, DifferenceRules rules, double level) {
    const std::size_t tile = grid.tiles.index(column, row);
    const DifferenceSums& sums = grid.at(tile, channel);
    TileTest test{.box = grid.tiles.boxes[tile], .channel = channel};
    test.pixels = sums.pixels;
    if (sums.pixels == 0) return test;
    rules.inflation = grid.inflations.tiles[tile];
    test.found = difference_of(sums, grid.around(column, row, channel), rules);
    test.state = state_of(sums, test.found, rules, level);
    forecast(test.found, test.state, rules, level);
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

// Normal scores of tiles, smaller where tails are heavy. Of an upper tail alone: errors that cancel between pixels (the
// particles of one light, blue noise, points shared over the picture) make the means of honest tiles agree far better
// than their pixels' variances say, so that agreement of tiles refutes nothing. Inflations that were measured make of
// the chi-square an F.
void add_chi_square(ChannelTest& test, const std::vector<TileTest>& tiles, std::size_t channel, double known_degrees) {
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
    test.upper_p = f_tail(cautious / degrees, degrees, known_degrees);
    test.lower_p = chi_square_lower_tail(test.chi_square, degrees);
}

/// What a deviation of b's mean is relative to: b's own there, or a part of the picture's, where that is more.
double scale_of(const DifferenceSums& sums, const DifferenceSums& picture, double floor) {
    const auto size = [](const DifferenceSums& of) {
        return of.pixels > 0 ? std::abs(of.b) / static_cast<double>(of.pixels) : 0;
    };
    return std::max(size(sums), floor * size(picture));
}

ChannelTest channel_test(const Grid& grid, std::size_t channel, DifferenceRules rules,
                         const ComparisonSettings& settings) {
    const DifferenceSums& all = grid.totals[channel];
    ChannelTest test;
    if (all.pixels == 0) return test;
    const double scale = scale_of(all, all, 1),
                 level = settings.alpha * parts_of_alpha::means / static_cast<double>(grid.channels);
    rules.delta = settings.delta * scale;
    rules.epsilon = settings.epsilon * scale;
    rules.inflation = grid.inflations.picture[channel];
    test.mean = difference_of(all, all, rules);
    test.state = state_of(all, test.mean, rules, level);
    if (test.state != TileState::no_variance && test.mean.p_value < level) test.state = TileState::differs;
    forecast(test.mean, test.state, rules, level);
    return test;
}

/// The inflation of the variances of sums over the picture, both sides and all channels together.
double inflation_of(const Grid& grid) {
    double inflated = 0, independent = 0;
    for (std::size_t c = 0; c < grid.channels; ++c) {
        const DifferenceSums& all = grid.totals[c];
        inflated += all.variance_a * grid.inflations.picture[c].a + all.variance_b * grid.inflations.picture[c].b;
        independent += all.variance_a + all.variance_b;
    }
    return independent > 0 ? inflated / independent : 1;
}

/// What can be said of two pictures without knowing their errors.
ImageComparison described(const Picture& a, const Picture& b, const ComparisonSettings& settings) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    ImageComparison found{.bad_a = a.bad_pixels, .bad_b = b.bad_pixels, .error_known = false};
    for (std::size_t c = 0; c < a.channels.size(); ++c) {
        const DifferenceSums sums = sums_of(a, b, {0, 0, a.width, a.height}, c);
        const auto n = static_cast<double>(sums.pixels);
        ChannelTest test{.channel = a.channels[c], .state = TileState::error_unknown};
        test.mean = {.a = sums.a / n, .b = sums.b / n, .difference = (sums.a - sums.b) / n, .standard_error = unknown};
        test.mean.delta = settings.delta * std::abs(test.mean.b);
        test.mean.degrees = test.mean.skewness = test.mean.z = test.mean.p_value = unknown;
        test.mean.interval = {unknown, unknown};
        test.chi_square = test.upper_p = test.lower_p = unknown;
        found.channels.push_back(test);
    }
    found.alike = found.unlike = {unknown, unknown};
    found.errors = errors_of(a, b, unknown);
    found.copies = copies_of(a, b);
    found.verdict = no_verdict(found, a, b);
    return found;
}

}  // namespace

ImageComparison compare(const Picture& a, const Picture& b, const ComparisonSettings& settings) {
    require_alike(a, b);
    if (!a.error_known || !b.error_known) return described(a, b, settings);
    ImageComparison found{.bad_a = a.bad_pixels, .bad_b = b.bad_pixels};
    found.correlation = correlation_of(a, b);
    const Grid grid = summed(a, b, tile_edge(a, settings.tile, found.correlation), found.correlation);
    found.tile = grid.tiles.tile;
    found.columns = grid.tiles.columns;
    found.rows = grid.tiles.rows;
    DifferenceRules rules{.degrees_a = a.degrees, .degrees_b = b.degrees, .beta = settings.beta};

    std::vector<double> spikes;
    for (std::size_t c = 0; c < grid.channels; ++c) {
        rules.spike = spikes.emplace_back(largest_spike(a, b, c));
        found.channels.push_back(channel_test(grid, c, rules, settings));
        found.channels.back().channel = a.channels[c];
    }
    const double level = settings.alpha * parts_of_alpha::tiles;
    for (int row = 0; row < found.rows; ++row)
        for (int column = 0; column < found.columns; ++column)
            for (std::size_t c = 0; c < grid.channels; ++c) {
                const double scale =
                    scale_of(grid.at(grid.tiles.index(column, row), c), grid.totals[c], settings.tile_floor);
                rules.spike = spikes[c];
                rules.delta = settings.tile_delta * scale;
                rules.epsilon = settings.epsilon * scale;
                found.tiles.push_back(
                    tile_test(grid, column, row, c, rules, level / static_cast<double>(grid.sums.size())));
            }
    found.differing = refuted_tiles(found.tiles, level);
    for (const std::size_t i : found.differing) found.tiles[i].state = TileState::differs;
    found.undecided = undecided_tiles(found.tiles);
    for (std::size_t c = 0; c < grid.channels; ++c)
        add_chi_square(found.channels[c], found.tiles, c, grid.inflations.degrees);
    found.correlation.inflation = inflation_of(grid);
    const double inflation = std::max(1.0, found.correlation.inflation);
    // Whatever tiles were asked for: of a few large ones the spread is not well known.
    const PixelGrid blocks = grid_of(a.width, a.height, tile_edge(a, 0, found.correlation));
    found.alike = too_alike(a, b, blocks, inflation);
    found.unlike = too_unlike(a, b, blocks, inflation, [&](const PixelBox& box, std::size_t c) {
        if (settings.epsilon == 0) return 0.0;
        return settings.epsilon * scale_of(sums_of(a, b, box, c), grid.totals[c], settings.tile_floor);
    });
    found.errors = errors_of(a, b, inflation);
    found.copies = copies_of(a, b);
    found.verdict = verdict_of(found, a, b, settings);
    return found;
}

}  // namespace plumb
