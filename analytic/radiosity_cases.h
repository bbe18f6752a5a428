#pragma once

#include <array>
#include <string>
#include <vector>

#include "analytic/radiosity.h"

namespace plumb {

/// A point of a plate, as its point(s, t).
struct PlatePoint {
    std::size_t plate;
    double s, t;
};

/// Plates whose radiance is known at some points.
struct RadiosityCase {
    std::string id, title;
    std::vector<RadiosityPlate> plates;
    std::vector<PlatePoint> points;
    double error;  ///< of Radiosity(plates, 8) there, relative: what n = 12 changes is less
};

/// The unit cube from inside: floor, ceiling, then the walls.
inline std::vector<RadiosityPlate> cube(const std::array<double, 6>& albedos, const std::array<double, 6>& emissions) {
    std::vector<RadiosityPlate> faces{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0, 0}, {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 0, 0},
                                      {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, 0}, {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 0, 0},
                                      {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 0}, {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 0, 0}};
    for (std::size_t i = 0; i < faces.size(); ++i) {
        faces[i].albedo = albedos[i];
        faces[i].emission = emissions[i];
    }
    return faces;
}
constexpr std::array<double, 6> uneven_albedos{0.6, 0.3, 0.7, 0.4, 0.5, 0.5}, lit_from_above{0, 1, 0, 0, 0, 0};

/// Unit squares that face each other, the upper of which shines.
inline std::vector<RadiosityPlate> facing_plates(double distance, double lower_albedo, double upper_albedo) {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0, lower_albedo},
            {{0, 0, distance}, {0, 1, 0}, {1, 0, 0}, 1, upper_albedo}};
}

inline std::vector<RadiosityCase> radiosity_cases() {
    const std::array<double, 6> halves{0.5, 0.5, 0.5, 0.5, 0.5, 0.5};
    return {{"two-plates", "Between two plates", facing_plates(0.5, 0.8, 0.6), {{0, 0.1, 0.3}, {1, 0.2, 0.4}}, 1e-7},
            {"closed-box", "In a closed box of albedo ½", cube(halves, lit_from_above), {{2, 0.6, 0.4}}, 2e-5},
            {"uneven-box",
             "In a closed box of different albedos",
             cube(uneven_albedos, lit_from_above),
             {{0, 0.3, 0.4}, {3, 0.5, 0.5}},
             2e-5}};
}

}  // namespace plumb
