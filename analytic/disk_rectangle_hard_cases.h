#pragma once

#include <string>
#include <vector>

#include "analytic/disk_rectangle.h"

namespace plumb {

/// A disk and a rectangle that holds its centre, where the area's formula could cancel.
struct DiskCase {
    std::string name;
    Point<2> centre;
    double radius;
    Rectangle rectangle{};
};

/// Centres on corners and sides, circles that touch a side or pass through a corner, slits of width 1e-12, radii from
/// 1e-300 to 1e300.
inline std::vector<DiskCase> disk_rectangle_hard_cases() {
    std::vector<DiskCase> cases{
        {"centre on a corner", {0, 0}, 0.75},
        {"centre on a corner, all but the far corner", {0, 0}, 1.414213562373095},
        {"centre on a side, touching another", {0, 0.25}, 0.25},
        {"touching from inside", {0.5, 0.5}, 0.5},
        {"just across a side", {0.5, 0.5}, 0.5 + 0x1p-40},
        {"just short of the corners", {0.5, 0.5}, 0.7071067811865475},
        {"just across the corners", {0.5, 0.5}, 0.7071067811865476},
        {"beside a side", {0x1p-40, 0.5}, 0.25},
        {"beside a corner", {0x1p-40, 0x1p-60}, 0.25},
        {"flat slit", {0.5, 0.5}, 0.25, {{0, 0.5}, {1, 0.5 + 1e-12}}},
        {"flat slit that the disk just holds", {0.5, 0.5}, 0.5, {{0, 0.5 - 1e-12}, {1, 0.5 + 1e-12}}},
        {"tall slit", {0.5, 0.5}, 0.25, {{0.5 - 1e-12, 0}, {0.5, 1}}},
        {"flat slit that just cuts the disk's ends",
         {0.5, 0.5},
         0.25,
         {{0.25 + 1e-13, 0.5 - 1e-6}, {0.75 - 1e-13, 0.5}}},
        {"larger than everything", {0.3, 0.7}, 1e300},
        {"as small as doubles square", {0.3, 0}, 1e-150},
    };
    for (int k = 1; k <= 12; ++k) cases.push_back({"radius " + std::to_string(k) + "/10", {0.37, 0.81}, k / 10.0});
    return cases;
}

}  // namespace plumb
