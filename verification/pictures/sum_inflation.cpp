#include "verification/pictures/sum_inflation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/moments.h"
#include "verification/evidence/f_distribution.h"

namespace plumb {
namespace {

/// How often the larger of two estimates is taken though they estimate the same.
constexpr double choice_risk = 0.001;

/// Is this variance significantly larger than that one?
bool larger(double variance, double degrees, double than, double than_degrees) {
    return variance > than && than > 0 && f_tail(variance / than, degrees, than_degrees) < choice_risk;
}

struct Estimate {
    double value = 1, degrees = Inflation::known;
};

/// Of one side, tile by tile, channel by channel: the sums of each render's deviations, and of variances.
class Spread {
public:
    Spread(const Picture& side, const Picture& other, const PixelGrid& grid)
        : grid_(grid), channels_(side.channels.size()), renders_(side.residuals.size()) {
        const std::size_t count = grid.boxes.size() * channels_;
        sums_.assign(count * renders_, 0);
        variances_.assign(count, 0);
        for (std::size_t tile = 0; tile < grid.boxes.size(); ++tile)
            for_pixels(grid.boxes[tile], [&](int x, int y) {
                for (std::size_t c = 0; c < channels_; ++c) {
                    const std::size_t k = side.at(x, y, c), at = tile * channels_ + c;
                    if (!std::isfinite(side.mean[k]) || !std::isfinite(other.mean[k])) continue;
                    variances_[at] += side.variance[k];
                    for (std::size_t r = 0; r < renders_; ++r) sums_[at * renders_ + r] += side.residuals[r][k];
                }
            });
    }

    [[nodiscard]] double degrees() const { return static_cast<double>(renders_) - 1; }
    [[nodiscard]] double variance(std::size_t channel) const {
        double sum = 0;
        for (std::size_t at = channel; at < variances_.size(); at += channels_) sum += variances_[at];
        return sum;
    }

    /// Of the sum over these tiles, of the mean of the renders: unbiased, of degrees() degrees of freedom.
    [[nodiscard]] double variance_of_sum(const std::vector<std::size_t>& tiles, std::size_t channel) const {
        double squares = 0;
        for (std::size_t r = 0; r < renders_; ++r) {
            double sum = 0;
            for (const std::size_t tile : tiles) sum += sums_[(tile * channels_ + channel) * renders_ + r];
            squares += sum * sum;
        }
        const auto n = static_cast<double>(renders_);
        return squares / n / (n - 1);
    }

    /// Of one tile, the mean over its channels that have errors; empty where none has.
    [[nodiscard]] std::optional<double> inflation(std::size_t tile) const {
        Moments ratios;
        for (std::size_t c = 0; c < channels_; ++c)
            if (const double own = variances_[tile * channels_ + c]; own > 0)
                ratios.add(variance_of_sum({tile}, c) / own);
        if (ratios.count() == 0) return {};
        return ratios.mean();
    }

    /// Of the sum over the picture: of blocks of tiles, four or more along each edge where there are so many, added by
    /// [Satterthwaite 1946]; of the whole where that is significantly more.
    [[nodiscard]] Estimate of_picture(std::size_t channel) const {
        const int edge = std::max(1, std::min(grid_.columns, grid_.rows) / 4);
        std::vector<std::size_t> all;
        double sum = 0, squares = 0;
        for (int row = 0; row < grid_.rows; row += edge)
            for (int column = 0; column < grid_.columns; column += edge) {
                std::vector<std::size_t> block;
                for (int v = row; v < std::min(grid_.rows, row + edge); ++v)
                    for (int u = column; u < std::min(grid_.columns, column + edge); ++u)
                        block.push_back(grid_.index(u, v));
                const double own = variance_of_sum(block, channel);
                sum += own;
                squares += own * own / (degrees() + 2);
                all.insert(all.end(), block.begin(), block.end());
            }
        const double pixels = variance(channel);
        if (!(sum > 0) || !(pixels > 0)) return {};
        const double of_blocks = std::max(1.0, sum * sum / squares - 2), whole = variance_of_sum(all, channel);
        if (larger(whole, degrees(), sum, of_blocks)) return {whole / pixels, degrees()};
        return {sum / pixels, of_blocks};
    }

private:
    const PixelGrid& grid_;
    std::size_t channels_, renders_;
    std::vector<double> sums_, variances_;
};

std::vector<Estimate> tiles_of(const Spread& spread, const PixelGrid& grid) {
    std::vector<std::optional<double>> own;
    for (std::size_t tile = 0; tile < grid.boxes.size(); ++tile) own.push_back(spread.inflation(tile));
    const auto about = [&](int column, int row, int reach) {
        Moments moments;
        for_tiles_about(grid, column, row, reach, [&](std::size_t tile) {
            if (own[tile]) moments.add(*own[tile]);
        });
        if (moments.count() == 0) return Estimate{};
        return Estimate{moments.mean(), spread.degrees() * static_cast<double>(moments.count())};
    };
    std::vector<Estimate> tiles;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const Estimate wide = about(column, row, 2), close = about(column, row, 1);
            tiles.push_back(larger(close.value, close.degrees, wide.value, wide.degrees) ? close : wide);
        }
    return tiles;
}

SumInflations of_spread(const Picture& a, const Picture& b, const PixelGrid& grid) {
    SumInflations found{.tiles = std::vector<Inflation>(grid.boxes.size()),
                        .picture = std::vector<Inflation>(a.channels.size()),
                        .of_spread = true};
    double per_degree = 0, whole = 0;
    const auto measure = [&](const Picture& side, const Picture& other, double Inflation::*value,
                             double Inflation::*degrees) {
        if (side.residuals.empty()) return;
        const Spread spread(side, other, grid);
        const std::vector<Estimate> tiles = tiles_of(spread, grid);
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            found.tiles[i].*value = tiles[i].value;
            found.tiles[i].*degrees = tiles[i].degrees;
        }
        double variance = 0;
        for (std::size_t c = 0; c < found.picture.size(); ++c) {
            const Estimate picture = spread.of_picture(c);
            found.picture[c].*value = picture.value;
            found.picture[c].*degrees = picture.degrees;
            variance += picture.value * spread.variance(c);
        }
        per_degree += variance * variance / (spread.degrees() * static_cast<double>(tiles.size()));
        whole += variance;
    };
    measure(a, b, &Inflation::a, &Inflation::degrees_a);
    measure(b, a, &Inflation::b, &Inflation::degrees_b);
    if (per_degree > 0) found.degrees = whole * whole / per_degree;
    return found;
}

SumInflations of_differences(const Picture& a, const Picture& b, const PixelGrid& grid,
                             const Correlation& correlation) {
    const auto both = [](double value, double degrees) {
        return Inflation{std::max(1.0, value), std::max(1.0, value), degrees, degrees};
    };
    const Inflation picture = both(correlation.inflation, correlation.degrees);
    SumInflations found{
        .tiles = {}, .picture = std::vector<Inflation>(a.channels.size(), picture), .degrees = correlation.degrees};
    for (const LocalCorrelation& local : correlations_about(a, b, grid, correlation))
        found.tiles.push_back(local.excess > 3 ? both(local.inflation, local.degrees) : picture);
    return found;
}

bool tells_sums(const Picture& picture) {
    return picture.residuals.size() > 1 || std::isinf(picture.degrees);
}

}  // namespace

SumInflations inflations_of(const Picture& a, const Picture& b, const PixelGrid& grid, const Correlation& correlation) {
    if (tells_sums(a) && tells_sums(b)) return of_spread(a, b, grid);
    return of_differences(a, b, grid, correlation);
}

}  // namespace plumb
