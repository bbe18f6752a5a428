#pragma once

#include "analytic/disk_rectangle.h"

namespace plumb {

/// disk_rectangle_area() by integrating the chords with 50 digits: the truth for its stability. Slow.
double disk_rectangle_area_by_chords(const Point<2>& centre, double radius, const Rectangle& rectangle = {});

}  // namespace plumb
