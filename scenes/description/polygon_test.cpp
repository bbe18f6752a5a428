#include "scenes/description/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace plumb {
namespace {

using Corners = std::vector<std::array<float, 3>>;

struct Covered {
    Vec3 area;  ///< of the triangles, as vectors
    double unsigned_area;
    std::size_t triangles;
    std::string wrong;
};

Covered covered(const Corners& corners) {
    Mesh mesh;
    mesh.positions = corners;
    std::vector<std::uint32_t> indices(corners.size());
    std::iota(indices.begin(), indices.end(), 0u);
    Covered result{{}, 0, 0, add_polygon(mesh, indices)};
    result.triangles = mesh.triangles.size();
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.corners(i);
        const Vec3 area = cross(b - a, c - a) * 0.5;
        result.area += area;
        result.unsigned_area += length(area);
    }
    return result;
}

/// Half the sum of p × q over the edges, which no triangulation enters.
Vec3 area_of_edges(const Corners& corners) {
    Vec3 sum;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
        sum += cross(Vec3{p[0], p[1], p[2]}, Vec3{q[0], q[1], q[2]}) * 0.5;
    }
    return sum;
}

Corners on_plane(const std::vector<std::array<float, 2>>& outline, std::size_t axis) {
    Corners corners;
    for (const auto& [x, y] : outline) {
        // On the plane z = x/2 − y/4, whose floats are exact, turned to face each axis.
        const std::array<float, 3> p{x, y, x / 2 - y / 4};
        corners.push_back({p[(3 - axis) % 3], p[(4 - axis) % 3], p[(5 - axis) % 3]});
    }
    return corners;
}

/// From every corner on, either way round, on planes that face every axis.
void expect_covers(const std::vector<std::array<float, 2>>& outline) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Corners corners = on_plane(outline, axis);
        for (std::size_t i = 0; i < 2 * corners.size(); ++i) {
            if (i == corners.size()) std::ranges::reverse(corners);
            std::ranges::rotate(corners, corners.begin() + 1);
            const Covered found = covered(corners);
            const Vec3 area = area_of_edges(corners);
            EXPECT_EQ(found.wrong, "");
            EXPECT_EQ(found.triangles, corners.size() - 2);
            EXPECT_NEAR(length(found.area - area), 0, 1e-12 * length(area));
            EXPECT_NEAR(found.unsigned_area, length(area), 1e-12 * length(area));
        }
    }
}

TEST(Polygon, FacesWithNotchesAreCoveredOnceFromAnyCornerOn) {
    expect_covers({{-1, -1}, {0, -1}, {0, 0}, {1, 0}, {1, 1}, {-1, 1}});                              // an L
    expect_covers({{0, 0}, {3, 0}, {3, 4}, {2, 4}, {2, 1}, {1, 1}, {1, 4}, {0, 4}});                  // a doorway
    expect_covers({{0, 0}, {4, 0}, {1, 1}, {0, 4}});                                                  // an arrow's head
    expect_covers({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});  // flat corners
    expect_covers({{0, 0}, {5, 0}, {5, 5}, {1, 5}, {1, 2}, {3, 2}, {3, 3}, {2, 3}, {2, 4}, {4, 4}, {4, 1}, {0, 1}});
}

TEST(Polygon, RandomStarsAreCoveredOnce) {
    std::mt19937 random(7);
    for (int n = 5; n < 20; n += 3) {
        std::vector<std::array<float, 2>> outline;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * M_PI * i / n, radius = 0.2 + static_cast<double>(random() % 1000) / 1000;
            // Rounded to 2^-12, so that the plane's third coordinate is exact.
            const auto rounded = [](double x) { return static_cast<float>(std::round(x * 4096) / 4096); };
            outline.push_back({rounded(radius * std::cos(angle)), rounded(radius * std::sin(angle))});
        }
        expect_covers(outline);
    }
}

TEST(Polygon, ConvexFacesAreFansFromTheirFirstCorner) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}};
    EXPECT_EQ(add_polygon(mesh, std::array{0u, 1u, 2u, 3u, 4u}), "");
    using T = std::array<std::uint32_t, 3>;
    EXPECT_EQ(mesh.triangles, (std::vector<T>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(Polygon, NearlyFlatCornersAreDecidedExactly) {
    // The third corner lies inwards of the edge by one unit in the last place.
    const float inwards = std::nextafter(1.f, 2.f);
    const Covered found = covered({{0, 1, 0}, {-1, 3, 0}, {-2, 1, 0}, {-1, inwards, 0}});
    EXPECT_EQ(found.wrong, "");
    EXPECT_NEAR(found.unsigned_area, 2 - 0x1p-23, 1e-14);
}

TEST(Polygon, RepeatedCornersAndFacesWithoutAreaAreNoError) {
    EXPECT_NEAR(covered({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}}).unsigned_area, 0.5, 1e-15);
    EXPECT_EQ(covered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).wrong, "");
}

TEST(Polygon, CrossingsAndHolesAreNamed) {
    const auto wrong = [](const Corners& corners) { return covered(corners).wrong.substr(0, 62); };
    EXPECT_EQ(wrong({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}),
              "a face whose edges from corner to corner 1–2 and 3–4 cross");
    // A pentagram turns one way at every corner.
    Corners star;
    for (int i = 0; i < 5; ++i)
        star.push_back({static_cast<float>(std::cos(i * 0.8 * M_PI)), static_cast<float>(std::sin(i * 0.8 * M_PI)), 0});
    EXPECT_EQ(wrong(star), "a face whose edges from corner to corner 1–2 and 3–4 cross");
    const Corners bridged{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0},
                          {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
    EXPECT_NE(covered(bridged).wrong, "");
    EXPECT_EQ(covered(bridged).triangles, 0u);
}

}  // namespace
}  // namespace plumb
