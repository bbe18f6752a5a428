#include "estimators/points/halton.h"

#include "estimators/points/point_count.h"
#include "estimators/points/strata.h"

namespace plumb {
namespace {

template <int D, class At>
std::vector<Point<D>> sequence(std::uint64_t n, const char* name, At at) {
    std::vector<Point<D>> points(point_count(n, name));
    for (std::uint32_t i = 0; i < n; ++i) points[i] = at(i);
    return points;
}

}  // namespace

double radical_inverse(std::uint32_t base, std::uint32_t i) {
    std::uint64_t mirrored = 0, scale = 1;  // scale ≤ i · base < 2^64, so one rounding in all: the division's
    for (; i > 0; i /= base) {
        mirrored = mirrored * base + i % base;
        scale *= base;
    }
    return static_cast<double>(mirrored) / static_cast<double>(scale);
}

std::vector<Point<1>> halton_1d(std::uint64_t n) {
    return sequence<1>(n, "halton", [](std::uint32_t i) { return Point<1>{radical_inverse(2, i)}; });
}

std::vector<Point<2>> halton_2d(std::uint64_t n) {
    return sequence<2>(n, "halton", [](std::uint32_t i) {
        return Point<2>{radical_inverse(2, i), radical_inverse(3, i)};
    });
}

std::vector<Point<1>> hammersley_1d(std::uint64_t n) {
    return sequence<1>(n, "hammersley", [n](std::uint32_t i) { return Point<1>{stratum_edge(i, n)}; });
}

std::vector<Point<2>> hammersley_2d(std::uint64_t n) {
    return sequence<2>(n, "hammersley", [n](std::uint32_t i) {
        return Point<2>{stratum_edge(i, n), radical_inverse(2, i)};
    });
}

}  // namespace plumb
