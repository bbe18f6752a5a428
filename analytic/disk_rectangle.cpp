#include "analytic/disk_rectangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb {
namespace {

/// Area of [0,w] × [0,h] ∩ the disk of radius r around the origin, odd in w and in h.
///
/// For r = 1 and 0 ≤ w, h ≤ 1 with the corner (w,h) outside the disk, the region falls into two triangles and a sector:
/// below the chord point (w, √(1−w²)), at angle α, left of the chord point (√(1−h²), h), at angle β, and between them:
///
///     ½ [ w √(1−w²) + h √(1−h²) + β − α ].
///
/// With h ≤ w, β is of the order of h, hence of the area, so the difference β − α costs no relative accuracy.
double quarter(double w, double h, double r) {
    if (w < 0) return -quarter(-w, h, r);
    if (h < 0) return -quarter(w, -h, r);
    if (w < h) std::swap(w, h);
    if (h >= r) return std::numbers::pi / 4 * r * r;
    w = std::min(w, r);
    const double x = w / r, y = h / r;
    if (x * x + y * y <= 1) return w * h;
    const double chord_x = std::sqrt((1 - x) * (1 + x)), chord_y = std::sqrt((1 - y) * (1 + y));
    const double alpha = std::atan2(chord_x, x), beta = std::atan2(y, chord_y);
    return (x * chord_x + y * chord_y + std::max(0.0, beta - alpha)) / 2 * r * r;
}

}  // namespace

double disk_rectangle_area(const Point<2>& centre, double radius, const Rectangle& rectangle) {
    if (radius == 0) return 0;
    const double left = centre[0] - rectangle.low[0], right = rectangle.high[0] - centre[0];
    const double down = centre[1] - rectangle.low[1], up = rectangle.high[1] - centre[1];
    return quarter(left, down, radius) + quarter(right, down, radius) + quarter(left, up, radius) +
           quarter(right, up, radius);
}

}  // namespace plumb
