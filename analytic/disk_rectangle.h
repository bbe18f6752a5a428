#pragma once

#include "core/point.h"

namespace plumb {

struct Rectangle {
    Point<2> low{0, 0}, high{1, 1};  ///< low ≤ high, axis by axis; the default is the unit square
};

/// Area of the part of the disk that lies in the rectangle; radius ≥ 0. Relative error ≤ 8 ulp while the centre lies
/// in the rectangle (all terms are positive then), absolute error ≤ 16 · 2^-53 · radius² elsewhere.
double disk_rectangle_area(const Point<2>& centre, double radius, const Rectangle& rectangle = {});

}  // namespace plumb
