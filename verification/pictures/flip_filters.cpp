#include "verification/pictures/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"

namespace plumb::flip {
namespace {

constexpr double squared_pi = std::numbers::pi * std::numbers::pi;

/// exp(−π² x²/scale), x in degrees.
Weights bell(double scale, double pixels_per_degree, int radius) {
    Weights weights;
    for (int i = -radius; i <= radius; ++i)
        weights.push_back(std::exp(-squared_pi * std::pow(i / pixels_per_degree, 2) / scale));
    return weights;
}

double sum_of(const Weights& weights) {
    double sum = 0;
    for (const double w : weights) sum += w;
    return sum;
}

Weights of_sum_one(Weights weights) {
    const double sum = sum_of(weights);
    for (double& w : weights) w /= sum;
    return weights;
}

Weights of_sums_one(Weights weights) {
    double positive = 0, negative = 0;
    for (const double w : weights) (w > 0 ? positive : negative) += std::abs(w);
    for (double& w : weights) w /= w > 0 ? positive : negative;
    return weights;
}

/// Calls visit(y) for each row.
template <class Visit>
void for_rows(const Plane& plane, Visit visit) {
    constexpr int rows = 16;
    for_batches(static_cast<std::size_t>((plane.height + rows - 1) / rows), [&](std::size_t batch) {
        const int first = static_cast<int>(batch) * rows;
        for (int y = first; y < std::min(plane.height, first + rows); ++y) visit(y);
    });
}

std::size_t start_of(const Plane& plane, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(plane.width);
}

void add_scaled(const double* from, double scale, double* to, int count) {
    for (int i = 0; i < count; ++i) to[i] += scale * from[i];
}

}  // namespace

std::vector<Blur> contrast_sensitivity(int number, double pixels_per_degree) {
    struct Bell {
        double height, scale;
    };
    constexpr double widest = 0.04;
    const std::vector<Bell> bells = number == 0   ? std::vector<Bell>{{1, 0.0047}}
                                    : number == 1 ? std::vector<Bell>{{1, 0.0053}}
                                                  : std::vector<Bell>{{34.1, widest}, {13.5, 0.025}};
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * squared_pi)) * pixels_per_degree));
    std::vector<Blur> blurs;
    double whole = 0;
    for (const auto& [height, scale] : bells) {
        Weights weights = bell(scale, pixels_per_degree, radius);
        const double share = height * std::sqrt(std::numbers::pi / scale) * std::pow(sum_of(weights), 2);
        blurs.push_back({of_sum_one(std::move(weights)), share});
        whole += share;
    }
    for (Blur& blur : blurs) blur.share /= whole;
    return blurs;
}

FeatureFilters feature_filters(double pixels_per_degree) {
    constexpr double width = 0.082;  // in degrees, of the detector of edges: two standard deviations
    const double deviation = 0.5 * width * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    FeatureFilters filters;
    for (int i = -radius; i <= radius; ++i) {
        const double g = std::exp(-i * i / (2 * deviation * deviation));
        filters.smooth.push_back(g);
        filters.edge.push_back(-i * g);
        filters.point.push_back((i * i / (deviation * deviation) - 1) * g);
    }
    return {of_sum_one(filters.smooth), of_sums_one(filters.edge), of_sums_one(filters.point)};
}

Plane along_x(const Plane& plane, const Weights& weights) {
    const std::size_t radius = weights.size() / 2;
    Plane result{plane.width, plane.height, std::vector<double>(plane.values.size())};
    for_rows(plane, [&](int y) {
        const auto row = plane.values.begin() + static_cast<std::ptrdiff_t>(start_of(plane, y));
        std::vector<double> padded(radius, *row);
        padded.insert(padded.end(), row, row + plane.width);
        padded.insert(padded.end(), radius, *(row + plane.width - 1));
        for (std::size_t i = 0; i < weights.size(); ++i)
            add_scaled(&padded[i], weights[i], &result.values[start_of(plane, y)], plane.width);
    });
    return result;
}

Plane along_y(const Plane& plane, const Weights& weights) {
    const int radius = static_cast<int>(weights.size() / 2);
    Plane result{plane.width, plane.height, std::vector<double>(plane.values.size())};
    for_rows(plane, [&](int y) {
        for (int i = -radius; i <= radius; ++i) {
            const int from = std::clamp(y + i, 0, plane.height - 1);
            add_scaled(&plane.values[start_of(plane, from)], weights[static_cast<std::size_t>(i + radius)],
                       &result.values[start_of(plane, y)], plane.width);
        }
    });
    return result;
}

}  // namespace plumb::flip
