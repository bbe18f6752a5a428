#include "checks/bsdf/cubature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plumb::checks {
namespace {

TEST(Cubature, IsExactForDegreeSeven) {
    const auto f = [](double x, double y) { return x * x * x * x * y * y * y + 3 * x * x * y * y + y + 2; };
    const Cubature result = integrate(f, {{0, 1, 0, 1}, {1, 2, 0, 2}}, {}, {.tolerance = 1, .evaluations = 0});
    EXPECT_NEAR(result.regions[0].value, 1.0 / 20 + 1.0 / 3 + 0.5 + 2, 1e-14);
    EXPECT_NEAR(result.regions[1].value, 31.0 / 5 * 4 + 7.0 * 8 / 3 + 2 + 4, 1e-12);
    EXPECT_NEAR(result.total, result.regions[0].value + result.regions[1].value, 1e-12);
}

TEST(Cubature, FindsAKinkAndOwnsItsError) {
    const auto f = [](double x, double y) { return std::abs(x - 0.3 * y - 0.2); };
    const Cubature result = integrate(f, {{0, 1, 0, 1}}, {}, {.tolerance = 1e-7, .evaluations = 200000});
    // ∫ ((a² + (1−a)²)/2) dy over a = 0.2 + 0.3 y
    const double truth = (0.125 - 0.008) / 0.9 / 2 + (0.512 - 0.125) / 0.9 / 2;
    EXPECT_NEAR(result.total, truth, 1e-7);
    EXPECT_LE(result.error, 1e-7);
}

TEST(Cubature, OwnsTheErrorOfAnEdge) {
    const auto disk = [](double x, double y) { return std::hypot(x - 0.4, y - 0.45) < 0.1 ? 1 : 0; };
    const Cubature result = integrate(disk, {{0, 1, 0, 1}}, {{0.41, 0.4}}, {.tolerance = 0, .evaluations = 40000});
    EXPECT_NEAR(result.total, 0.01 * std::numbers::pi, result.error);
    EXPECT_LT(result.error, 1e-3);
}

TEST(Cubature, FindsAPeakWhereAPlaceIs) {
    constexpr double width = 1e-7;
    const auto peak = [](double x, double y) {
        return std::exp(-(std::pow((x - 0.3) / width, 2) + std::pow((y - 0.7) / width, 2)) / 2);
    };
    const double truth = 2 * std::numbers::pi * width * width;
    const Cubature blind = integrate(peak, {{0, 1, 0, 1}}, {}, {.tolerance = 1e-4 * truth, .evaluations = 40000});
    EXPECT_LT(blind.total, 0.01 * truth);
    const Cubature result =
        integrate(peak, {{0, 1, 0, 1}}, {{0.3 + width, 0.7}}, {.tolerance = 1e-4 * truth, .evaluations = 40000});
    EXPECT_NEAR(result.total, truth, 1e-4 * truth);
}

TEST(Cubature, KnowsThePartOfAPlace) {
    const auto f = [](double x, double y) { return x * y; };
    const Cubature result =
        integrate(f, {{0, 1, 0, 1}, {1, 2, 0, 1}}, {}, {.tolerance = 1, .evaluations = 40000, .largest = 0.01});
    EXPECT_GT(result.parts.size(), 100U);
    for (std::size_t i = 0; i < result.parts.size(); ++i) {
        const Rectangle& r = result.regions[result.parts[i]].rectangle;
        EXPECT_EQ(result.part_at({(r.x_low + r.x_high) / 2, (r.y_low + r.y_high) / 2}), i);
        EXPECT_LE(result.regions[result.parts[i]].value, 0.01);
    }
}

}  // namespace
}  // namespace plumb::checks
