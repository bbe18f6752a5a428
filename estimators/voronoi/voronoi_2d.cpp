// SPDX-License-Identifier: GPL-3.0-or-later (CGAL's 2D triangulations)
#include "estimators/voronoi/voronoi_2d.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>

#include "estimators/voronoi/sample_check.h"

// Topology comes from exact predicates, coordinates from double arithmetic relative to the cell's sample, so that cells
// of a tight cluster lose nothing to cancellation.

namespace plumb {
namespace {

struct Cell {
    std::uint32_t samples = 0;  ///< that coincide here; 0 for helper points, whose cells are not asked for
    double share = 0;           ///< area / samples
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Position = Kernel::Point_2;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<Cell, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices>>;

struct Vector {
    double x, y;
};
Vector operator-(const Position& a, const Position& b) {
    return {a.x() - b.x(), a.y() - b.y()};
}
Vector operator+(Vector a, Vector b) {
    return {a.x + b.x, a.y + b.y};
}
double cross(Vector a, Vector b) {
    return a.x * b.y - a.y * b.x;
}
double squared_length(Vector a) {
    return a.x * a.x + a.y * a.y;
}
double largest(Vector a) {
    return std::max(std::abs(a.x), std::abs(a.y));
}

/// Inserts the points along a space-filling curve and returns the vertex of each.
std::vector<Delaunay::Vertex_handle> insert(Delaunay& triangulation, const std::vector<Position>& points) {
    if (points.empty()) return {};
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto position = CGAL::make_property_map(points);
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(position)>(position));
    std::vector<Delaunay::Vertex_handle> vertices(points.size());
    Delaunay::Face_handle near;
    for (const std::size_t i : order) {
        vertices[i] = triangulation.insert(points[i], near);
        near = vertices[i]->face();
    }
    return vertices;
}

// No circle through a sample that is empty of the helper points of bounded_cells(), or of the samples on the torus, has
// a larger radius: with S the helper farthest in the direction u of the centre as seen from the sample A,
// R ≤ |S−A|²/(2(S−A)·u) ≤ 9.25/(2(2.5−1)/√2) < 4.4.
constexpr double largest_radius = 5;

/// The factor that keeps products of differences as small as 2^-1074 from underflowing.
double safe_scale(Vector a) {
    return largest(a) < 0x1p-300 ? 0x1p700 : 1;
}

/// The centre of the face's circle, relative to `origin`, a vertex of the face.
/// It is computed from the vertex opposite the longest edge: the sine of the angle there, the longest edge over the
/// diameter, is the condition number. A triangle so flat that rounding swallows it has edges below 1e-15, and what
/// cells gain or lose along it is at most that: its centre is put at the largest distance that can be.
Vector circumcentre(Delaunay::Face_handle face, const Position& origin) {
    const auto edge_opposite = [&](int i) {
        return largest(face->vertex(Delaunay::ccw(i))->point() - face->vertex(Delaunay::cw(i))->point());
    };
    const std::array<double, 3> edges{edge_opposite(0), edge_opposite(1), edge_opposite(2)};
    const int i = static_cast<int>(std::ranges::max_element(edges) - edges.begin());
    const Position& pivot = face->vertex(i)->point();
    Vector a = face->vertex(Delaunay::ccw(i))->point() - pivot, b = face->vertex(Delaunay::cw(i))->point() - pivot;
    const double scale_a = safe_scale(a), scale_b = safe_scale(b);
    a = {a.x * scale_a, a.y * scale_a};
    b = {b.x * scale_b, b.y * scale_b};
    const double twice = 2 * cross(a, b);
    const double along_b = squared_length(a) / twice / scale_a, along_a = squared_length(b) / twice / scale_b;
    Vector centre{along_b * b.y - along_a * a.y, along_a * a.x - along_b * b.x};
    if (!(twice > 0) || squared_length(centre) > largest_radius * largest_radius) {
        const Vector edge = face->vertex(Delaunay::cw(i))->point() - face->vertex(Delaunay::ccw(i))->point();
        const double length = std::hypot(edge.x, edge.y);
        centre = {edge.y / length * largest_radius, -edge.x / length * largest_radius};
    }
    return centre + (pivot - origin);
}

/// Calls visit for each face around the vertex, counter-clockwise.
template <class Visit>
void for_faces_around(const Delaunay& triangulation, Delaunay::Vertex_handle vertex, Visit visit) {
    auto face = triangulation.incident_faces(vertex);
    const auto first = face;
    do visit(Delaunay::Face_handle(face));
    while (++face != first);
}

double signed_area(const std::vector<Vector>& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return twice / 2;
}

/// Keeps the part of the polygon where outside(v) ≤ 0; outside is affine [Sutherland & Hodgman 1974].
template <class Outside>
void clip(std::vector<Vector>& polygon, std::vector<Vector>& scratch, Outside outside) {
    scratch.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector from = polygon[i], to = polygon[(i + 1) % polygon.size()];
        const double a = outside(from), b = outside(to);
        if (a <= 0) scratch.push_back(from);
        if ((a < 0 && b > 0) || (a > 0 && b < 0)) {
            const double t = a / (a - b);
            scratch.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
        }
    }
    polygon.swap(scratch);
}

/// Gives every sample's vertex its share of the cell that outline() leaves in the polygon it is handed.
template <class Outline>
std::vector<double> shares(const Delaunay& triangulation, const std::vector<Delaunay::Vertex_handle>& vertices,
                           std::size_t samples, Outline outline) {
    std::vector<Vector> polygon, scratch;
    for (const Delaunay::Vertex_handle vertex : triangulation.finite_vertex_handles()) {
        Cell& cell = vertex->info();
        if (cell.samples == 0) continue;
        polygon.clear();
        for_faces_around(triangulation, vertex,
                         [&](Delaunay::Face_handle face) { polygon.push_back(circumcentre(face, vertex->point())); });
        outline(vertex->point(), polygon, scratch);
        cell.share = std::max(0.0, signed_area(polygon)) / cell.samples;  // rounding may leave an empty cell below 0
    }
    std::vector<double> weights(samples);
    for (std::size_t i = 0; i < samples; ++i) weights[i] = vertices[i]->info().share;
    return weights;
}

void count_samples(const std::vector<Delaunay::Vertex_handle>& vertices, std::size_t samples) {
    for (std::size_t i = 0; i < samples; ++i) ++vertices[i]->info().samples;
}

/// The periodic copies of the sites (in [−½,½)²) whose largest coordinate lies in (½ + from, ½ + to].
void add_copies(std::vector<Position>& points, const std::vector<Position>& sites, double from, double to) {
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j) {
            if ((i == 0 && j == 0) || std::max(std::abs(i), std::abs(j)) - 1 > to) continue;
            for (const Position& site : sites) {
                const double x = site.x() + i, y = site.y() + j, extent = std::max(std::abs(x), std::abs(y)) - 0.5;
                if (from < extent && extent <= to) points.emplace_back(x, y);
            }
        }
}

/// The distance by which the circles around the samples' faces reach beyond the unit cell; empty when a face is
/// infinite or all points are collinear.
std::optional<double> reach(const Delaunay& triangulation) {
    if (triangulation.dimension() < 2) return std::nullopt;
    double farthest = 0;
    bool finite = true;
    for (const Delaunay::Vertex_handle vertex : triangulation.finite_vertex_handles()) {
        if (vertex->info().samples == 0) continue;
        for_faces_around(triangulation, vertex, [&](Delaunay::Face_handle face) {
            if (!finite || triangulation.is_infinite(face)) {
                finite = false;
                return;
            }
            const Vector centre = circumcentre(face, vertex->point());
            const Vector from_middle = centre + Vector{vertex->point().x(), vertex->point().y()};
            farthest = std::max(farthest, largest(from_middle) + std::sqrt(squared_length(centre)) - 0.5);
        });
        if (!finite) return std::nullopt;
    }
    return farthest;
}

}  // namespace

std::vector<double> voronoi_areas(std::span<const Point<2>> samples) {
    check_samples<2>(samples);
    std::vector<Position> points;
    points.reserve(samples.size() + 4);
    for (const Point<2>& x : samples) points.emplace_back(x[0], x[1]);
    // Four helpers around the square make every cell finite and change none inside it: they are 2 away from the square,
    // in which no point is farther than √2 from a sample.
    for (const auto& [x, y] : {std::pair{-2.0, 0.5}, {3.0, 0.5}, {0.5, -2.0}, {0.5, 3.0}}) points.emplace_back(x, y);

    Delaunay triangulation;
    const auto vertices = insert(triangulation, points);
    count_samples(vertices, samples.size());
    return shares(triangulation, vertices, samples.size(),
                  [](const Position& site, std::vector<Vector>& polygon, std::vector<Vector>& scratch) {
                      const double left = -site.x(), right = 1 - site.x(), down = -site.y(), up = 1 - site.y();
                      const auto inside = [&](Vector v) {
                          return left <= v.x && v.x <= right && down <= v.y && v.y <= up;
                      };
                      if (std::ranges::all_of(polygon, inside)) return;
                      clip(polygon, scratch, [&](Vector v) { return left - v.x; });
                      clip(polygon, scratch, [&](Vector v) { return v.x - right; });
                      clip(polygon, scratch, [&](Vector v) { return down - v.y; });
                      clip(polygon, scratch, [&](Vector v) { return v.y - up; });
                  });
}

std::vector<double> voronoi_areas_periodic(std::span<const Point<2>> samples) {
    check_samples<2>(samples);
    const auto centred = [](double x) {  // a multiple of 2^-52 in [−½, ½)
        const double rounded = std::nearbyint(x * 0x1p52) * 0x1p-52;
        return (rounded < 1 ? rounded : 0) - 0.5;
    };
    std::vector<Position> sites;
    sites.reserve(samples.size());
    for (const Point<2>& x : samples) sites.emplace_back(centred(x[0]), centred(x[1]));

    // Copies within √2 are always enough: no empty circle on the torus has a radius above √2/2. Far fewer mostly do,
    // and it is seen whether they did: when the circles around the samples' faces reach only where all copies are
    // present, they are empty on the torus too, so the faces and with them the cells are those of the torus.
    constexpr double all = std::numbers::sqrt2;
    const double n = static_cast<double>(sites.size());
    double covered = std::min(all, 2 * std::sqrt((0.5 * std::log(n) + 4) / (std::numbers::pi * n)));
    std::vector<Position> points = sites;
    add_copies(points, sites, -1, covered);
    Delaunay triangulation;
    const auto vertices = insert(triangulation, points);
    count_samples(vertices, sites.size());
    while (covered < all) {
        const double needed = reach(triangulation).value_or(2 * covered) + 1e-9;  // a margin for rounding
        if (needed <= covered) break;
        std::vector<Position> more;
        add_copies(more, sites, covered, std::min(all, needed));
        insert(triangulation, more);
        covered = std::min(all, needed);
    }
    return shares(triangulation, vertices, sites.size(), [](const Position&, const auto&, const auto&) {});
}

}  // namespace plumb
