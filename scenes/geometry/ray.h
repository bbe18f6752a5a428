#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/vec3.h"

namespace plumb {

/// A ray, or a segment: origin + t direction, t in (0, t_max).
struct Ray {
    Vec3 origin, direction;
    double t_max = HUGE_VAL;
};

/// A ray that was traced: for the nearest hit, or to learn whether anything is in its way.
struct TracedRay {
    Ray ray;
    bool shadow;
};

/// A count of the rays that a caller has traced, and the rays themselves where somebody wants to see them.
struct RayLog {
    std::uint64_t count = 0;
    std::vector<TracedRay>* kept = nullptr;

    void add(const Ray& ray, bool shadow) {
        ++count;
        if (kept) kept->push_back({ray, shadow});
    }
};

}  // namespace plumb
