#pragma once

#include <cmath>

#include "core/vec3.h"

namespace plumb {

/// A ray, or a segment: origin + t direction, t in (0, t_max).
struct Ray {
    Vec3 origin, direction;
    double t_max = HUGE_VAL;
};

}  // namespace plumb
