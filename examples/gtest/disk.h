// Somebody's renderer: a point of the unit disk from two numbers in [0,1).
#pragma once

#include <cmath>
#include <numbers>

struct Polar {
    double radius, angle;
};

inline Polar sample_disk(double u, double v) {
    return {std::sqrt(u), 2 * std::numbers::pi * v};
}
