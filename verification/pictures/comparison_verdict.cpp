#include "verification/pictures/comparison_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/pictures/samples_needed.h"

namespace plumb {
namespace {

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
        if (channel.upper_p < settings.alpha * parts_of_alpha::chi_square / channels)
            parts.push_back(fmt::format("the tiles of {} differ together: chi-square {:.4g} of {} degrees of freedom",
                                        channel.channel, channel.chi_square, channel.degrees));
    }
    if (found.unlike.p_value < settings.alpha * parts_of_alpha::unlike)
        parts.push_back(
            fmt::format("pixels differ by more than their errors: squared differences are {:.3g} of what the variances "
                        "say in the mean",
                        found.unlike.ratio));
    if (found.alike.p_value < settings.alpha * parts_of_alpha::alike)
        parts.push_back(
            fmt::format("pixels are too alike for independent errors: their squared t, bounded, is {:.3g} in the mean, "
                        "not 1 or more, as if {:.0f} % of their samples were the same, or the variances were too large",
                        found.alike.ratio, 100 * std::clamp(1 - found.alike.ratio, 0.0, 1.0)));
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
    return text;
}

std::string doubt(const ImageComparison& found, const Picture& a, const Picture& b) {
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
    SamplesNeeded needed;
    for (const ChannelTest& channel : found.channels) needed.add(channel.mean, channel.state);
    for (const std::size_t tile : found.undecided) needed.add(found.tiles[tile].found, found.tiles[tile].state);
    std::vector<const Picture*> sides;
    for (const Picture* side : {&a, &b})
        if (!std::isinf(side->degrees)) sides.push_back(side);
    if (const std::string more = words_of(needed, sides); !more.empty()) add(more);
    return text;
}

}  // namespace

bool may_differ(const TileTest& tile) {
    return tile.state != TileState::no_pixels && tile.state != TileState::no_variance;
}

std::string to_string(TileState state) {
    switch (state) {
        case TileState::same: return "same";
        case TileState::differs: return "differs";
        case TileState::too_noisy: return "too noisy";
        case TileState::heavy_tails: return "heavy tails";
        case TileState::no_variance: return "one side shows no variance";
        case TileState::poorly_known: return "its known value is less certain than delta";
        case TileState::error_unknown: return "its error is unknown";
        case TileState::no_pixels: return "no finite pixels";
    }
    return "";
}

Verdict no_verdict(const ImageComparison& found, const Picture& a, const Picture& b) {
    const bool both = !a.error_known && !b.error_known;
    const char *side = a.error_known ? "b" : "a", *option = a.error_known ? "--b" : "--a";
    Verdict verdict;
    verdict.resolution = std::numeric_limits<double>::infinity();
    verdict.reason = fmt::format(
        "no verdict, because the error of {} is unknown: {} one image without layers variance.{} …; two or more "
        "independent renders of {} ({}), or images with such layers, would tell it{}",
        both ? "a and b" : side, both ? "each is" : "it is", a.channels[0], both ? "each" : "it",
        both ? "--a, --b" : option, b.error_known ? "" : ", and --exact-b says that b has none");
    if (!found.copies.empty()) verdict.reason = found.copies + ": " + verdict.reason;
    return verdict;
}

Verdict verdict_of(const ImageComparison& found, const Picture& a, const Picture& b,
                   const ComparisonSettings& settings) {
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
        verdict.reason = doubt(found, a, b);
        verdict.outcome = Outcome::undecided;
    }
    const bool noisy = std::ranges::any_of(found.channels, [](const auto& c) { return c.mean.standard_error > 0; });
    if (!found.copies.empty() && (noisy || !verdict.reason.empty()))
        verdict.reason = found.copies + (verdict.reason.empty() ? "" : ": " + verdict.reason);
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
                        {"mean_squared_difference", found.unlike.ratio},
                        {"variance_inflation", found.correlation.inflation}};
    return verdict;
}

}  // namespace plumb
