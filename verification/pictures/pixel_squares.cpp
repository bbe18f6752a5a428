#include "verification/pictures/pixel_squares.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/moments.h"
#include "verification/evidence/distributions.h"
#include "verification/pictures/mean_difference.h"

namespace plumb {
namespace {

// ---- a mean over pixels with its error

/// Terms of pixels, tile by tile.
struct TileTerms {
    Moments pixels;
    std::vector<double> sums = {}, counts = {};  // of tiles

    void add(const Moments& tile) {
        pixels.merge(tile);
        if (tile.count() == 0) return;
        sums.push_back(tile.mean() * static_cast<double>(tile.count()));
        counts.push_back(static_cast<double>(tile.count()));
    }
    /// Of the mean over all pixels, as tiles spread: whatever the pixels of one have in common.
    [[nodiscard]] double variance_of_tiles() const {
        const auto n = static_cast<double>(pixels.count()), tiles = static_cast<double>(sums.size());
        double squares = 0;
        for (std::size_t i = 0; i < sums.size(); ++i) squares += std::pow(sums[i] - pixels.mean() * counts[i], 2);
        return tiles > 1 ? squares / n / n * tiles / (tiles - 1) : 0;
    }
};

/// P of a mean so far below 0 (sign −1) or above (1), by the larger of two variances: of pixels, each at least of this
/// variance and as inflated as a sum of values is, and of tiles.
double tail_of(const TileTerms& terms, double sign, double least_variance, double inflation) {
    if (terms.pixels.count() < 2 || !(sign * terms.pixels.mean() > 0)) return 1;
    const auto n = static_cast<double>(terms.pixels.count());
    const double of_pixels = std::max(terms.pixels.variance(), least_variance) * inflation / n,
                 of_tiles = terms.variance_of_tiles();
    const double t = std::abs(terms.pixels.mean()) / std::sqrt(std::max(of_pixels, of_tiles));
    const double skewness = terms.pixels.variance() > 0 ? std::abs(terms.pixels.skewness()) : 0;
    const double z = of_tiles > of_pixels ? normal_score_of_student(t, static_cast<double>(terms.sums.size()) - 1) : t;
    return std::min(1.0, skewed_p_value(z, (skewness + 2 * std::sqrt(6 / n)) * std::sqrt(inflation / n)) / 2);
}

// ---- too alike

// t² = d²/(va + vb), of ν degrees of freedom, as t² (ν + 1)/(ν + t²): at most ν + 1, whatever spikes there are, with
// expectation 1 for normal errors and for any whose difference is as likely to have the other sign [Efron 1969], and
// more for others. Empty where rounding may hide what noise there is: equal constants say nothing, and the variance
// that a renderer found for them is what rounding left of it.
std::optional<double> bounded_square(const Picture& a, const Picture& b, std::size_t k, double per_degree) {
    const double difference = a.mean[k] - b.mean[k], size = std::abs(a.mean[k]) + std::abs(b.mean[k]);
    const double hidden = std::max(std::max(a.rounding, b.rounding) * size, a.rounding_at(k) + b.rounding_at(k));
    const double unknown = a.variance_rounding + b.variance_rounding;
    const double variance = a.variance[k] + b.variance[k], told_from_constants = std::max(8 * hidden, 5e-5 * size);
    if (std::abs(difference) <= hidden && variance <= told_from_constants * told_from_constants + 8 * unknown)
        return {};
    const double square = difference * difference, whole = variance + square * per_degree;
    if (!(whole > 0) || !std::isfinite(whole)) return {};
    return square * (1 + per_degree) / whole;
}

// 1/ν of va + vb [Satterthwaite 1946], at the most balanced of the middle half of a tile's shares va/(va + vb): its
// spikes have most of the variance, but are few of the pixels. Where ν is too large, squares are too.
double per_degree_in(const Picture& a, const Picture& b, const PixelBox& box, std::size_t channel) {
    std::vector<double> shares;
    for_pixels(box, [&](int x, int y) {
        const std::size_t k = a.at(x, y, channel);
        if (const double both = a.variance[k] + b.variance[k]; both > 0) shares.push_back(a.variance[k] / both);
    });
    double share = std::isinf(b.degrees) ? 0 : std::isinf(a.degrees) ? 1 : a.degrees / (a.degrees + b.degrees);
    if (!shares.empty()) {
        const auto quarter = static_cast<std::ptrdiff_t>(shares.size() / 4);
        std::ranges::sort(shares);
        share = std::clamp(share, *(shares.begin() + quarter), *(shares.end() - 1 - quarter));
    }
    return share * share / a.degrees + (1 - share) * (1 - share) / b.degrees;
}

// ---- too unlike

/// Sums of variances, tile by tile, channel by channel.
struct TileVariances {
    std::vector<double> sums, of_a, of_b, pixels;
    std::size_t channels;

    TileVariances(const Picture& a, const Picture& b, const PixelGrid& grid)
        : sums(grid.boxes.size() * a.channels.size()),
          of_a(sums.size()),
          of_b(sums.size()),
          pixels(sums.size()),
          channels(a.channels.size()) {
        for (std::size_t tile = 0; tile < grid.boxes.size(); ++tile)
            for_pixels(grid.boxes[tile], [&](int x, int y) {
                for (std::size_t c = 0; c < channels; ++c) {
                    const std::size_t k = a.at(x, y, c);
                    if (!std::isfinite(a.mean[k] - b.mean[k])) continue;
                    const std::size_t at = tile * channels + c;
                    of_a[at] += a.variance[k];
                    of_b[at] += b.variance[k];
                    sums[at] += a.variance[k] + b.variance[k];
                    ++pixels[at];
                }
            });
    }
    /// Whether each side that is an estimate shows errors there: one that shows none may lack paths never found.
    [[nodiscard]] bool shows_errors(std::size_t tile, std::size_t channel, const Picture& a, const Picture& b) const {
        const std::size_t at = tile * channels + channel;
        return (of_a[at] > 0 || std::isinf(a.degrees)) && (of_b[at] > 0 || std::isinf(b.degrees));
    }
    /// The mean over 5x5 tiles: of one tile's few pixels, it would depend on the squares that it divides.
    [[nodiscard]] double about(const PixelGrid& grid, int column, int row, std::size_t channel) const {
        double sum = 0, count = 0;
        for_tiles_about(grid, column, row, 2, [&](std::size_t tile) {
            sum += sums[tile * channels + channel];
            count += pixels[tile * channels + channel];
        });
        return count > 0 ? sum / count : 0;
    }
};

}  // namespace

SquaresTest too_alike(const Picture& a, const Picture& b, const PixelGrid& grid, double inflation) {
    const std::size_t channels = a.channels.size();
    TileTerms excess;
    Moments normal_variance;  // of normal errors of one channel: shared samples have less, and equal images none
    std::vector<double> per_degree(channels);
    for (const PixelBox& box : grid.boxes) {
        for (std::size_t c = 0; c < channels; ++c) per_degree[c] = per_degree_in(a, b, box, c);
        Moments tile;
        for_pixels(box, [&](int x, int y) {
            Moments squares;
            for (std::size_t c = 0; c < channels; ++c)
                if (const auto square = bounded_square(a, b, a.at(x, y, c), per_degree[c])) squares.add(*square - 1);
            if (squares.count() == 0) return;
            tile.add(squares.mean());
            normal_variance.add(2 / (1 + 3 * per_degree[0]));
        });
        excess.add(tile);
    }
    if (excess.pixels.count() < 2) return {};
    return {1 + excess.pixels.mean(), tail_of(excess, -1, normal_variance.mean(), inflation)};
}

SquaresTest too_unlike(const Picture& a, const Picture& b, const PixelGrid& grid, double inflation,
                       const std::function<double(const PixelBox&, std::size_t channel)>& allowed) {
    constexpr double most = 8;  // of one pixel, which is to speak for itself: three standard deviations
    const std::size_t channels = a.channels.size();
    const TileVariances variances(a, b, grid);
    TileTerms excess;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const std::size_t index = grid.index(column, row);
            std::vector<double> scale(channels), none(channels);
            for (std::size_t c = 0; c < channels; ++c)
                if (variances.shows_errors(index, c, a, b)) scale[c] = variances.about(grid, column, row, c);
            for (std::size_t c = 0; c < channels; ++c) none[c] = allowed(grid.boxes[index], c);
            Moments tile;
            for_pixels(grid.boxes[index], [&](int x, int y) {
                Moments squares;
                for (std::size_t c = 0; c < channels; ++c) {
                    const std::size_t k = a.at(x, y, c);
                    const double far = std::abs(a.mean[k] - b.mean[k]) - a.rounding_at(k) - b.rounding_at(k),
                                 beyond = std::max(0.0, far - none[c]);
                    if (!std::isfinite(far) || !(scale[c] > 0)) continue;
                    const double variance = a.variance[k] + b.variance[k] + a.variance_rounding + b.variance_rounding;
                    squares.add(std::min(most, (beyond * beyond - variance) / scale[c]));
                }
                if (squares.count() > 0) tile.add(squares.mean());
            });
            excess.add(tile);
        }
    if (excess.pixels.count() < 2) return {};
    return {1 + excess.pixels.mean(), tail_of(excess, 1, 0, inflation)};
}

}  // namespace plumb
