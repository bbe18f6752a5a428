#include "analytic/disk_rectangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb {
namespace {

/// Area of [0,w] × [0,h] ∩ the unit disk, odd in w and in h.
///
/// For 0 ≤ w, h ≤ 1 with the corner (w,h) outside the disk, the region falls into two triangles and a sector: below the
/// chord point (w, √(1−w²)), at angle α, left of the chord point (√(1−h²), h), at angle β, and between the angles:
///
///     ½ [ w √(1−w²) + h √(1−h²) + β − α ].
///
/// With h ≤ w, β is of the order of h, hence of the area, so the difference β − α costs no relative accuracy.
double quarter(double w, double h) {
    if (w < 0) return -quarter(-w, h);
    if (h < 0) return -quarter(w, -h);
    if (w < h) std::swap(w, h);
    if (h >= 1) return std::numbers::pi / 4;
    w = std::min(w, 1.0);
    if (w * w + h * h <= 1) return w * h;
    const double chord_w = std::sqrt((1 - w) * (1 + w)), chord_h = std::sqrt((1 - h) * (1 + h));
    const double alpha = std::atan2(chord_w, w), beta = std::atan2(h, chord_h);
    return (w * chord_w + h * chord_h + std::max(0.0, beta - alpha)) / 2;
}

}  // namespace

double disk_rectangle_area(const Point<2>& centre, double radius, const Rectangle& rectangle) {
    if (radius == 0) return 0;
    const double left = (centre[0] - rectangle.low[0]) / radius, right = (rectangle.high[0] - centre[0]) / radius;
    const double down = (centre[1] - rectangle.low[1]) / radius, up = (rectangle.high[1] - centre[1]) / radius;
    const double unit = quarter(left, down) + quarter(right, down) + quarter(left, up) + quarter(right, up);
    return unit * radius * radius;
}

}  // namespace plumb
