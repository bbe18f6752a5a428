#include "estimators/voronoi/voronoi_hard_sets.h"

#include <cmath>
#include <numbers>

#include "core/random.h"

namespace plumb {
namespace {

std::vector<Point<2>> circle(int count, double radius, bool with_centre) {
    std::vector<Point<2>> samples;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        samples.push_back({0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)});
    }
    if (with_centre) samples.push_back({0.5, 0.5});
    return samples;
}

std::vector<Point<2>> line(int count, Point<2> from, Point<2> to) {
    std::vector<Point<2>> samples;
    for (int i = 0; i < count; ++i) {
        const double t = i / (count - 1.0);
        samples.push_back({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
    }
    return samples;
}

std::vector<Point<2>> grid(int side) {
    std::vector<Point<2>> samples;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) samples.push_back({(i + 0.5) / side, (j + 0.5) / side});
    return samples;
}

std::vector<Point<2>> cluster(int count, double width, Point<2> corner) {
    RandomStream random(7);
    std::vector<Point<2>> samples;
    for (int i = 0; i < count; ++i)
        samples.push_back({corner[0] + width * random.uniform(), corner[1] + width * random.uniform()});
    return samples;
}

std::vector<Point<2>> cluster_around_the_origin_of_the_torus() {
    std::vector<Point<2>> samples = cluster(64, 1e-12, {0, 0});
    for (int i = 0; i < 64; ++i)
        samples[i] = {i % 2 ? 1 - samples[i][0] : samples[i][0], i % 4 < 2 ? 1 - samples[i][1] : samples[i][1]};
    return samples;
}

}  // namespace

std::vector<HardSet> voronoi_hard_sets() {
    constexpr double tiny = 0x1p-1074, below_one = 1 - 0x1p-53;
    return {
        {"one-sample", {{0.25, 0.75}}},
        {"one-sample-on-a-corner", {{1, 0}}},
        {"two-samples", {{0.1, 0.7}, {0.6, 0.2}}},
        {"two-coincident", {{0.1, 0.7}, {0.1, 0.7}}},
        {"coincident-and-others", {{0.1, 0.7}, {0.5, 0.5}, {0.1, 0.7}, {0.9, 0.1}, {0.5, 0.5}, {0.1, 0.7}}},
        {"corners", {{0, 0}, {1, 0}, {0, 1}, {1, 1}}},
        {"corners-and-centre", {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0.5, 0.5}}},
        {"left-edge", line(33, {0, 0}, {0, 1})},
        {"opposite-edges", {{0, 0.3}, {1, 0.3}, {0, 0.8}, {1, 0.8}, {0.4, 0}, {0.4, 1}}},
        {"collinear-horizontal", line(64, {0.1, 0.5}, {0.9, 0.5})},
        {"collinear-diagonal", line(64, {0, 0}, {1, 1})},
        {"nearly-collinear", line(64, {0.1, 0.2}, {0.7, 0.9})},
        {"circle", circle(100, 0.4, false)},
        {"circle-with-centre", circle(100, 0.4, true)},
        {"large-circle-with-centre", circle(20000, 0.4, true)},
        {"tiny-circle", circle(100, 1e-13, true), false},
        {"grid", grid(16)},
        {"cluster", cluster(300, 1e-12, {0.3, 0.6}), false},
        {"cluster-of-10000", cluster(10000, 1e-12, {0.3, 0.6}), false},
        {"cluster-of-10000-at-the-corner", cluster(10000, 1e-12, {0, 0}), false},
        {"cluster-around-the-torus-origin", cluster_around_the_origin_of_the_torus(), false},
        {"smallest-and-largest", {{tiny, 0.5}, {below_one, 0.5}, {0.5, tiny}, {0.5, below_one}, {tiny, below_one}}},
        {"denormals", {{0, 0}, {tiny, 0}, {0, tiny}, {3 * tiny, 2 * tiny}, {1, 1}, {below_one, below_one}}, false},
        {"cluster-of-1e-300", cluster(200, 1e-300, {0, 0}), false},
    };
}

}  // namespace plumb
