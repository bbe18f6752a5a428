#include "estimators/voronoi/voronoi_brute_force.h"

#include <cmath>

#include "estimators/voronoi/sample_check.h"

namespace plumb {
namespace {

using Polygon = std::vector<Point<2>>;  // relative to the cell's sample

/// Cuts away what lies nearer to d than to the origin. Dividing by the larger coordinate of d keeps d² from
/// underflowing.
Polygon nearer_to_origin(const Polygon& polygon, Point<2> d) {
    const double size = std::max(std::abs(d[0]), std::abs(d[1]));
    const Point<2> u{d[0] / size, d[1] / size};
    const auto outside = [&](const Point<2>& v) { return v[0] * u[0] + v[1] * u[1] - (d[0] * u[0] + d[1] * u[1]) / 2; };
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point<2> from = polygon[i], to = polygon[(i + 1) % polygon.size()];
        const double a = outside(from), b = outside(to);
        if (a <= 0) kept.push_back(from);
        if ((a < 0 && b > 0) || (a > 0 && b < 0))
            kept.push_back({from[0] + a / (a - b) * (to[0] - from[0]), from[1] + a / (a - b) * (to[1] - from[1])});
    }
    return kept;
}

double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point<2>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice / 2;
}

Polygon rectangle(double left, double right, double down, double up) {
    return {{left, down}, {right, down}, {right, up}, {left, up}};
}

}  // namespace

std::vector<double> brute_force_voronoi_areas(std::span<const Point<2>> samples) {
    check_samples<2>(samples);
    std::vector<double> areas;
    for (const Point<2>& site : samples) {
        Polygon cell = rectangle(-site[0], 1 - site[0], -site[1], 1 - site[1]);
        double coincident = 0;
        for (const Point<2>& other : samples)
            if (other == site)
                ++coincident;
            else
                cell = nearer_to_origin(cell, {other[0] - site[0], other[1] - site[1]});
        areas.push_back(area(cell) / coincident);
    }
    return areas;
}

std::vector<double> brute_force_voronoi_areas_periodic(std::span<const Point<2>> samples) {
    check_samples<2>(samples);
    std::vector<double> areas;
    for (const Point<2>& site : samples) {
        // A cell reaches at most half a period along each axis: there the site's own copies are nearer. Within it,
        // copies up to one and a half periods from the site matter.
        Polygon cell = rectangle(-0.5, 0.5, -0.5, 0.5);
        double coincident = 0;
        for (const Point<2>& other : samples) {
            const Point<2> d{std::remainder(other[0] - site[0], 1.0), std::remainder(other[1] - site[1], 1.0)};
            if (d == Point<2>{0, 0}) {
                ++coincident;
                continue;
            }
            for (int i = -1; i <= 1; ++i)
                for (int j = -1; j <= 1; ++j) cell = nearer_to_origin(cell, {d[0] + i, d[1] + j});
        }
        areas.push_back(area(cell) / coincident);
    }
    return areas;
}

}  // namespace plumb
