#include "verification/pictures/image_correlation.h"

#include <algorithm>
#include <cmath>

#include "core/moments.h"

namespace plumb {
namespace {

/// Standardised errors, one a pixel; 0 where there is none.
using Errors = std::vector<float>;

// One noisy pixel must not speak for all.
double clipped(double error, double variance) {
    return variance > 0 ? std::clamp(error / std::sqrt(variance), -3.0, 3.0) : 0;
}

bool of_residuals(const Picture& a, const Picture& b) {
    const auto has_spread = [](const Picture& p) { return !p.residuals.empty() || std::isinf(p.degrees); };
    return has_spread(a) && has_spread(b) && !(a.residuals.empty() && b.residuals.empty());
}

// The channels' mean, after clipping.
template <class Of>
Errors errors(const Picture& a, Of of_channel) {
    const std::size_t count = a.channels.size();
    Errors field(a.mean.size() / count);
    for (std::size_t p = 0; p < field.size(); ++p) {
        double sum = 0;
        for (std::size_t c = 0; c < count; ++c) sum += of_channel(p * count + c);
        field[p] = std::isfinite(sum) ? static_cast<float>(sum / static_cast<double>(count)) : 0.f;
    }
    return field;
}

/// Calls with the places of each block.
template <class Visit>
void for_blocks(int width, int height, int block, Visit visit) {
    for (int y = 0; y < height; y += block)
        for (int x = 0; x < width; x += block) {
            std::vector<std::size_t> places;
            for (int v = y; v < std::min(height, y + block); ++v)
                for (int u = x; u < std::min(width, x + block); ++u)
                    places.push_back(static_cast<std::size_t>(v) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(u));
            visit(places);
        }
}

/// The mean over the places that have an error.
double mean_at(const Errors& field, const std::vector<std::size_t>& places) {
    double sum = 0;
    std::size_t count = 0;
    for (const std::size_t place : places) {
        sum += field[place];
        count += field[place] != 0;
    }
    return count > 0 ? sum / static_cast<double>(count) : 0;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

// Blocks whose means lie far from the others' show a bias, not a correlation: their errors are taken out.
void drop_outliers(Errors& field, int width, int height) {
    constexpr int block = 8;
    std::vector<double> means;
    for_blocks(width, height, block, [&](const auto& places) {
        if (const double mean = mean_at(field, places); mean != 0) means.push_back(mean);
    });
    const double middle = median(means);
    for (double& mean : means) mean = std::abs(mean - middle);
    const double farthest = 3 * 1.4826 * median(means);  // three standard deviations, if normal
    for_blocks(width, height, block, [&](const auto& places) {
        if (std::abs(mean_at(field, places) - middle) > farthest)
            for (const std::size_t place : places) field[place] = 0;
    });
}

// Less the mean of larger blocks, in which a bias is about constant.
void flatten(Errors& field, int width, int height) {
    constexpr int block = 16;
    for_blocks(width, height, block, [&](const auto& places) {
        const auto mean = static_cast<float>(mean_at(field, places));
        for (const std::size_t place : places)
            if (field[place] != 0) field[place] -= mean;
    });
}

Errors differences(const Picture& a, const Picture& b) {
    Errors field =
        errors(a, [&](std::size_t k) { return clipped(a.mean[k] - b.mean[k], a.variance[k] + b.variance[k]); });
    drop_outliers(field, a.width, a.height);
    flatten(field, a.width, a.height);
    return field;
}

std::vector<Errors> fields_of(const Picture& a, const Picture& b) {
    std::vector<Errors> fields;
    for (const Picture* picture : {&a, &b})
        for (const std::vector<float>& residual : picture->residuals)
            fields.push_back(errors(*picture, [&](std::size_t k) {
                return clipped(residual[k], picture->variance[k] * static_cast<double>(picture->renders));
            }));
    if (of_residuals(a, b)) return fields;
    return {differences(a, b)};
}

/// Distances of pairs of pixels that are `ring` columns or rows apart, the larger of both; each pair once.
template <class Visit>
void for_lags(int ring, Visit visit) {
    for (int dy = 0; dy <= ring; ++dy)
        for (int dx = -ring; dx <= ring; ++dx)
            if (std::max(std::abs(dx), dy) == ring && (dy > 0 || dx > 0)) visit(dx, dy);
}

/// Of errors in a box with those so far from them.
double products(const Errors& field, const PixelBox& box, int width, int height, int dx, int dy) {
    double found = 0;
    const int end_x = std::min(box.x + box.width, width - std::max(0, dx)),
              end_y = std::min(box.y + box.height, height - dy);
    for (int y = box.y; y < end_y; ++y)
        for (int x = std::max(box.x, -dx); x < end_x; ++x)
            found += static_cast<double>(field[static_cast<std::size_t>(y * width + x)]) *
                     field[static_cast<std::size_t>((y + dy) * width + x + dx)];
    return found;
}

/// The share of squared differences that is more than the variances say, and that a bias has, with its standard error.
/// Its expectation is 0 for true estimates, correlated or not.
struct Excess {
    double value = 0, error = 0;
};

Excess excess_of(const Picture& a, const Picture& b) {
    constexpr int block = 16;
    const std::size_t count = a.channels.size();
    Moments moments;
    for_blocks(a.width, a.height, block, [&](const auto& places) {
        double own = 0;
        std::size_t noisy = 0;
        for (const std::size_t p : places)
            for (std::size_t k = p * count; k < (p + 1) * count; ++k)
                if (const double v = a.variance[k] + b.variance[k]; v > 0 && std::isfinite(a.mean[k] - b.mean[k])) {
                    own += v;
                    ++noisy;
                }
        for (const std::size_t p : places) {
            double sum = 0;
            for (std::size_t k = p * count; k < (p + 1) * count; ++k) {
                const double d = a.mean[k] - b.mean[k], v = a.variance[k] + b.variance[k];
                if (std::isfinite(d) && v > 0) sum += (d * d - v) * static_cast<double>(noisy) / own;
            }
            moments.add(sum / static_cast<double>(count));
        }
    });
    return {moments.mean(), moments.standard_error()};
}

/// Correlations ring by ring, where a part of all products is known to be a bias's.
Correlation rings(const std::vector<Errors>& fields, const Picture& a, int farthest, double bias) {
    double squares = 0;
    std::uint64_t lively = 0;  // places that have an error at all
    for (const Errors& field : fields)
        for (const float e : field) {
            squares += static_cast<double>(e) * e;
            lively += e != 0;
        }
    Correlation found{.bias = bias};
    if (lively < 2 * fields.size()) return found;
    const double independent = static_cast<double>(lively) / static_cast<double>(fields.size());
    double all_lags = 0;
    for (int ring = 1; ring <= farthest && ring < std::min(a.width, a.height); ++ring) {
        double sum = 0, lags = 0;
        for_lags(ring, [&](int dx, int dy) {
            double found_here = 0;
            for (const Errors& field : fields)
                found_here += products(field, {0, 0, a.width, a.height}, a.width, a.height, dx, dy);
            sum += (found_here / squares - bias) / (1 - bias);
            ++lags;
        });
        // Sums of products over one lag have variance (Σe²)²/n where errors are independent.
        const double error = std::sqrt(lags / independent);
        if (ring == 1) found.resolution = 6 * error;
        if (sum < 3 * error) break;
        found.reach = ring;
        found.inflation += 2 * sum;
        all_lags += lags;
    }
    if (all_lags > 0) found.degrees = found.inflation * independent / (2 * all_lags);
    return found;
}

/// Sums over tiles, of what correlations are made of.
struct ProductSums {
    double products = 0, squares = 0, lively = 0;
    void add(const ProductSums& other, double sign) {
        products += sign * other.products;
        squares += sign * other.squares;
        lively += sign * other.lively;
    }
};

}  // namespace

Correlation correlation_of(const Picture& a, const Picture& b, int farthest) {
    const std::vector<Errors> fields = fields_of(a, b);
    const Correlation found = rings(fields, a, farthest, 0);
    if (of_residuals(a, b) || found.reach == 0) return found;
    const Excess excess = excess_of(a, b);
    if (excess.value < 3 * excess.error * std::sqrt(found.inflation)) return found;
    // By Cauchy and Schwarz a bias adds to no product more than to the squares.
    return rings(fields, a, farthest, excess.value / (1 + excess.value));
}

std::vector<LocalCorrelation> correlations_about(const Picture& a, const Picture& b, const PixelGrid& grid,
                                                 const Correlation& picture) {
    const Errors field = differences(a, b);
    std::vector<ProductSums> own(grid.boxes.size());
    double lags = 0;
    for (int ring = 1; ring <= std::max(1, picture.reach); ++ring) for_lags(ring, [&](int, int) { ++lags; });
    for (std::size_t tile = 0; tile < own.size(); ++tile) {
        for (int ring = 1; ring <= std::max(1, picture.reach); ++ring)
            for_lags(ring, [&](int dx, int dy) {
                own[tile].products += products(field, grid.boxes[tile], a.width, a.height, dx, dy);
            });
        for_pixels(grid.boxes[tile], [&](int x, int y) {
            const double e = field[static_cast<std::size_t>(y * a.width + x)];
            own[tile].squares += e * e;
            own[tile].lively += e != 0;
        });
    }
    std::vector<LocalCorrelation> found;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            ProductSums sums;
            for_tiles_about(grid, column, row, 2, [&](std::size_t tile) { sums.add(own[tile], 1); });
            sums.add(own[grid.index(column, row)], -1);
            LocalCorrelation& local = found.emplace_back();
            if (!(sums.squares > 0) || sums.lively < 2 * lags) continue;
            local.inflation = 1 + 2 * (sums.products / sums.squares - lags * picture.bias) / (1 - picture.bias);
            local.excess = (local.inflation - picture.inflation) /
                           (2 * std::sqrt(lags * std::max(1.0, picture.inflation) / sums.lively));
            local.degrees = std::max(1.0, local.inflation) * sums.lively / (2 * lags);
        }
    return found;
}

}  // namespace plumb
