#include "analytic/irradiance.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <numbers>

#include "core/error.h"

namespace plumb {
namespace {

using std::numbers::pi;

double integral(const auto& f, double from, double to, int pieces) {
    double sum = 0;
    for (int i = 0; i < pieces; ++i)
        sum += boost::math::quadrature::gauss<double, 15>::integrate(f, from + (to - from) * i / pieces,
                                                                     from + (to - from) * (i + 1) / pieces);
    return sum;
}

/// cos cos' / d² at a point of a surface with unit normal.
double kernel(Vec3 p, Vec3 n, Vec3 point, Vec3 normal) {
    const Vec3 way = point - p;
    const double d2 = length_squared(way);
    return std::max(0.0, dot(n, way)) * std::max(0.0, -dot(normal, way)) / (d2 * d2);
}

double rectangle_quadrature(Vec3 p, Vec3 n, Vec3 corner, Vec3 e1, Vec3 e2) {
    const Vec3 product = cross(e1, e2);
    const double area = length(product);
    return area *
           integral(
               [&](double s) {
                   return integral([&](double t) { return kernel(p, n, corner + s * e1 + t * e2, product / area); }, 0,
                                   1, 4);
               },
               0, 1, 4);
}

double disk_quadrature(Vec3 p, Vec3 n, Vec3 centre, Vec3 normal, double radius) {
    const Frame frame(normal);
    return integral(
        [&](double r) {
            return r * integral(
                           [&](double phi) {
                               const Vec3 local{r * std::cos(phi), r * std::sin(phi), 0};
                               return kernel(p, n, centre + frame.to_world(local), normal);
                           },
                           0, 2 * pi, 16);
        },
        0, radius, 8);
}

/// The irradiance by quadrature over the cap of directions, cut where it crosses the horizon.
double sphere_quadrature(Vec3 n, Vec3 centre, double radius) {
    const double d = length(centre), cap = std::asin(radius / d), tilt = std::acos(dot(n, centre) / d);
    const auto ring = [&](double theta) {
        // ∫ max(0, cos θ cos tilt + sin θ sin tilt cos φ) dφ
        const double a = std::cos(theta) * std::cos(tilt), b = std::sin(theta) * std::sin(tilt);
        const double end = a >= b ? pi : a <= -b ? 0 : std::acos(-a / b);
        return std::sin(theta) * 2 * integral([&](double phi) { return a + b * std::cos(phi); }, 0, end, 4);
    };
    const double bend = std::abs(pi / 2 - tilt);
    if (bend >= cap) return integral(ring, 0, cap, 8);
    // √ at the bend: θ = bend + x² smooths it
    return integral(ring, 0, bend, 8) +
           integral([&](double x) { return 2 * x * ring(bend + x * x); }, 0, std::sqrt(cap - bend), 16);
}

std::vector<Vec3> corners(Vec3 corner, Vec3 e1, Vec3 e2) {
    return {corner, corner + e1, corner + e1 + e2, corner + e2};
}

TEST(Irradiance, OfPolygonsIsTheirQuadrature) {
    const Vec3 e1{0, 1, 0}, e2{1.5, 0, 0};  // shines down
    for (const Vec3 n : {Vec3{0, 0, 1}, normalize({1, 2, 5}), normalize({-1, 1, 2})})
        for (const Vec3 corner : {Vec3{0.5, 0.5, 1}, Vec3{-0.7, -0.5, 2}, Vec3{3, 2, 4}}) {
            if (dot(n, corner) <= 0 || dot(n, corner + e1) <= 0 || dot(n, corner + e2) <= 0) continue;
            EXPECT_NEAR(polygon_irradiance({}, n, corners(corner, e1, e2)), rectangle_quadrature({}, n, corner, e1, e2),
                        1e-10);
        }
}

TEST(Irradiance, OfAPolygonIsCutAtTheHorizon) {
    // A wall from z = −1 to z = 2 that faces −x: what lies below z = 0 does not count.
    const Vec3 corner{1, -1, -1}, up{0, 0, 3}, along{0, 2, 0};
    EXPECT_NEAR(polygon_irradiance({}, {0, 0, 1}, corners(corner, up, along)),
                rectangle_quadrature({}, {0, 0, 1}, {1, -1, 0}, {0, 0, 2}, along), 1e-12);
    EXPECT_EQ(polygon_irradiance({}, {0, 0, 1}, corners(corner, along, up)), 0);  // from behind
    EXPECT_EQ(polygon_irradiance({}, {0, 0, -1}, corners({1, -1, 1}, up, along)), 0);
}

TEST(Irradiance, OfASphereIsItsQuadrature) {
    const Vec3 n{0, 0, 1};
    for (const double height : {-1.5, -0.9, -0.3, 0.0, 0.4, 0.99, 1.5, 4.0})
        for (const double aside : {1.2, 2.0, 7.0}) {
            const Vec3 centre{aside, 0.3, height};
            EXPECT_NEAR(sphere_irradiance({}, n, centre, 1), sphere_quadrature(n, centre, 1), 1e-11)
                << height << ' ' << aside;
        }
}

TEST(Irradiance, OfADiskIsItsQuadrature) {
    for (const Vec3 n : {Vec3{0, 0, 1}, normalize({1, 0.4, 1.5}), normalize({-0.5, 0.2, 1})})
        for (const Vec3 centre : {Vec3{0, 0, 1}, Vec3{0.6, 0.3, 2}, Vec3{3, 1, 2.5}, Vec3{0.2, 0, 0.8}})
            for (const Vec3 normal : {Vec3{0, 0, -1}, normalize({-0.3, 0.1, -1})}) {
                if (dot(n, centre) < 0.7 * length(cross(n, normal))) continue;
                EXPECT_NEAR(disk_irradiance({}, n, centre, normal, 0.7), disk_quadrature({}, n, centre, normal, 0.7),
                            1e-10);
            }
    EXPECT_THROW(static_cast<void>(disk_irradiance({}, {0, 0, 1}, {0, 0, -1}, {0, 0, -1}, 1)), Error);
}

TEST(FormFactors, AreTheMeanIrradianceOverPi) {
    const auto mean = [](double a, double b, const std::vector<Vec3>& light) {
        return integral(
                   [&](double x) {
                       return integral(
                           [&](double y) {
                               return polygon_irradiance({x, y, 0}, {0, 0, 1}, light);
                           },
                           0, b, 8);
                   },
                   0, a, 8) /
               (pi * a * b);
    };
    EXPECT_NEAR(parallel_rectangles_form_factor(2, 3, 1.5), mean(2, 3, corners({0, 0, 1.5}, {0, 3, 0}, {2, 0, 0})),
                1e-12);
    EXPECT_NEAR(parallel_rectangles_form_factor(1, 1, 1), 0.19982489569838746, 1e-15);
    // Common edge along y at x = 0; the light stands on it and faces +x. Near the edge the irradiance is not smooth.
    const double l = 3, w = 2, h = 1.5;
    const std::vector<Vec3> wall = corners({0, 0, 0}, {0, l, 0}, {0, 0, h});
    const double perpendicular = integral(
                                     [&](double root) {
                                         const double x = root * root * root;
                                         return 3 * root * root *
                                                integral(
                                                    [&](double y) {
                                                        return polygon_irradiance({x, y, 0}, {0, 0, 1}, wall);
                                                    },
                                                    0, l, 64);
                                     },
                                     0, std::cbrt(w), 16) /
                                 (pi * l * w);
    EXPECT_NEAR(perpendicular_rectangles_form_factor(l, w, h), perpendicular, 1e-6);
    EXPECT_NEAR(perpendicular_rectangles_form_factor(1, 1, 1), 0.20004377607540316, 1e-15);
}

TEST(FormFactors, OfABoxSumToOne) {
    const double a = 1, b = 2, c = 3;
    const double sum = parallel_rectangles_form_factor(a, b, c) + 2 * perpendicular_rectangles_form_factor(a, b, c) +
                       2 * perpendicular_rectangles_form_factor(b, a, c);
    EXPECT_NEAR(sum, 1, 1e-14);
}

TEST(ThinLens, SpreadsAPointOverADisk) {
    // The ray from (0.2, 0, 0) through (0, 0, 4) is at x = 0.1 where z = 2, and at −0.2 where z = 8.
    EXPECT_NEAR(circle_of_confusion(0.2, 2, 4), 0.1, 1e-15);
    EXPECT_NEAR(circle_of_confusion(0.2, 8, 4), 0.2, 1e-15);
    EXPECT_EQ(circle_of_confusion(0.2, 4, 4), 0);
}

}  // namespace
}  // namespace plumb
