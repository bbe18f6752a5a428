#include "estimators/points/antithetic.h"

namespace plumb {

namespace {

// Of k 2^-53 the image is (2^53 - 1 - k) 2^-53: exactly uniform, and below 1.
double mirrored(double u) {
    return 1 - 0x1p-53 - u;
}

}  // namespace

std::vector<Point<2>> antithetic_2d(std::uint64_t n, RandomStream& random) {
    std::vector<Point<2>> points(n);
    for (std::uint64_t i = 0; i < n; ++i) {
        if (i % 2 == 1) {
            points[i] = {mirrored(points[i - 1][0]), mirrored(points[i - 1][1])};
            continue;
        }
        const double x = random.uniform();
        points[i] = {x, random.uniform()};
    }
    return points;
}

}  // namespace plumb
