#include "scenes/description/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace plumb {

namespace {

/// A corner of the flat face: floats' values, so that the product of two is exact in double.
struct Point {
    double x, y;
    std::size_t corner;  ///< its number in the face

    [[nodiscard]] bool same_place(const Point& other) const { return x == other.x && y == other.y; }
};

/// The sign of the exact sum, by expansions that do not overlap [Shewchuk 1997, fig. 7].
int sign_of_sum(const std::array<double, 6>& terms) {
    double rounded = 0, sizes = 0;
    for (const double term : terms) rounded += term, sizes += std::abs(term);
    if (std::abs(rounded) > 0x1p-49 * sizes) return rounded > 0 ? 1 : -1;  // its error is at most 5·2^-53 of the sizes
    std::array<double, 6> parts{};
    for (std::size_t n = 0; n < terms.size(); ++n) {
        double q = terms[n];
        for (std::size_t i = 0; i < n; ++i) {
            const double sum = q + parts[i], virtual_part = sum - q;
            parts[i] = (q - (sum - virtual_part)) + (parts[i] - virtual_part);
            q = sum;
        }
        parts[n] = q;
    }
    // The last part that is not zero is larger than all others together.
    for (std::size_t i = parts.size(); i-- > 0;)
        if (parts[i] != 0) return parts[i] > 0 ? 1 : -1;
    return 0;
}

/// 1 where a, b, c turn counterclockwise, −1 where clockwise, 0 on one line: exact.
int turn(const Point& a, const Point& b, const Point& c) {
    return sign_of_sum({a.x * b.y, -a.x * c.y, b.x * c.y, -b.x * a.y, c.x * a.y, -c.x * b.y});
}

/// For three points on one line: whether p is between a and b, or one of them.
bool between(const Point& p, const Point& a, const Point& b) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
    const int abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && between(c, a, b)) || (abd == 0 && between(d, a, b)) || (cda == 0 && between(a, c, d)) ||
           (cdb == 0 && between(b, c, d));
}

/// The axis that the face faces most, by the sum of its fan's normals; by the largest of them where they cancel, as in
/// a face that crosses itself. None where the face has no area.
std::optional<std::size_t> facing_axis(const std::vector<Vec3>& corners) {
    Vec3 sum, largest;
    double lengths = 0;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const Vec3 normal = cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
        sum += normal;
        lengths += length(normal);
        if (length_squared(normal) > length_squared(largest)) largest = normal;
    }
    if (!(lengths > 0)) return std::nullopt;
    const Vec3 normal = length(sum) > 1e-6 * lengths ? sum : largest;
    const std::array size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    return static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
}

/// The corners as seen along the axis, those left out that stand where the one before does.
std::vector<Point> flattened(const std::vector<Vec3>& corners, std::size_t axis) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::array p{corners[i].x, corners[i].y, corners[i].z};
        const Point point{p[(axis + 1) % 3], p[(axis + 2) % 3], i};
        if (points.empty() || !points.back().same_place(point)) points.push_back(point);
    }
    while (points.size() > 1 && points.back().same_place(points.front())) points.pop_back();
    return points;
}

/// Whether the first corner sees the whole face: directions to the others turn one way, by less than a whole turn.
bool fan_covers(const std::vector<Point>& p) {
    int way = 0;
    bool beyond_half = false;
    for (std::size_t i = 2; i < p.size(); ++i) {
        const int step = turn(p[0], p[i - 1], p[i]);
        if (step == 0 && between(p[0], p[i - 1], p[i])) return false;
        if (way == 0) way = step;
        if (step * way < 0) return false;
        const int side = turn(p[0], p[1], p[i]) * way;
        if (beyond_half && side >= 0) return false;
        beyond_half = beyond_half || side < 0;
    }
    return true;
}

/// What crosses or touches what; empty for a simple polygon.
std::string crossing(const std::vector<Point>& p) {
    const std::size_t n = p.size();
    const auto edge = [&](std::size_t i) { return fmt::format("{}–{}", p[i].corner + 1, p[(i + 1) % n].corner + 1); };
    for (std::size_t i = 0; i < n; ++i) {
        const Point &a = p[i], &b = p[(i + 1) % n];
        for (std::size_t j = i + 1; j < n; ++j) {
            const Point &c = p[j], &d = p[(j + 1) % n];
            bool meet;
            if (j == i + 1)  // neighbours: only where the second folds back onto the first
                meet = turn(a, b, d) == 0 && (between(d, a, b) || between(a, b, d));
            else if (i == 0 && j == n - 1)
                meet = turn(c, a, b) == 0 && (between(b, c, a) || between(c, a, b));
            else
                meet = segments_meet(a, b, c, d);
            if (meet)
                return fmt::format(
                    "a face whose edges from corner to corner {} and {} cross or touch; faces without "
                    "holes and crossings are accepted",
                    edge(i), edge(j));
        }
    }
    return {};
}

/// Whether the corner between two others can be cut off: a proper triangle, without any other corner in or on it.
bool is_ear(const std::vector<Point>& p, std::size_t at, int way) {
    const std::size_t n = p.size();
    const Point &a = p[(at + n - 1) % n], &b = p[at], &c = p[(at + 1) % n];
    if (turn(a, b, c) != way) return false;
    return std::ranges::none_of(p, [&](const Point& q) {
        if (q.corner == a.corner || q.corner == b.corner || q.corner == c.corner) return false;
        return turn(a, b, q) * way >= 0 && turn(b, c, q) * way >= 0 && turn(c, a, q) * way >= 0;
    });
}

/// The simple polygon's triangles, as numbers of corners. Each cut leaves a simple polygon, which has an ear.
std::vector<std::array<std::size_t, 3>> ears(std::vector<Point> p) {
    const auto less = [](const Point& a, const Point& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); };
    const auto first = static_cast<std::size_t>(std::ranges::min_element(p, less) - p.begin());
    // The outermost corner is convex.
    const int way = turn(p[(first + p.size() - 1) % p.size()], p[first], p[(first + 1) % p.size()]);
    std::vector<std::array<std::size_t, 3>> triangles;
    std::size_t at = 0;
    while (p.size() > 2) {
        for (std::size_t tried = 0; tried < p.size() && !is_ear(p, at, way); ++tried) at = (at + 1) % p.size();
        const std::size_t n = p.size();
        triangles.push_back({p[(at + n - 1) % n].corner, p[at].corner, p[(at + 1) % n].corner});
        p.erase(p.begin() + static_cast<std::ptrdiff_t>(at));
        at %= p.size();
    }
    return triangles;
}

}  // namespace

std::string add_polygon(Mesh& mesh, std::span<const std::uint32_t> corners) {
    const auto add_fan = [&] {
        for (std::size_t i = 2; i < corners.size(); ++i)
            mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
        return std::string();
    };
    if (corners.size() == 3) return add_fan();
    std::vector<Vec3> positions;
    for (const std::uint32_t corner : corners) positions.push_back(mesh.position(corner));
    const auto axis = facing_axis(positions);
    if (!axis) return add_fan();
    const std::vector<Point> points = flattened(positions, *axis);
    if (fan_covers(points)) return add_fan();
    if (std::string wrong = crossing(points); !wrong.empty()) return wrong;
    for (const auto& [a, b, c] : ears(points)) mesh.triangles.push_back({corners[a], corners[b], corners[c]});
    return {};
}

}  // namespace plumb
