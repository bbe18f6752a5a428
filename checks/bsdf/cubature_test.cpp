#include "checks/bsdf/cubature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb::checks {
namespace {

TEST(Cubature, IsExactForDegreeSeven) {
    const auto f = [](double x, double y) { return x * x * x * x * y * y * y + 3 * x * x * y * y + y + 2; };
    const Cubature result = integrate(f, {{0, 1, 0, 1}, {1, 2, 0, 2}}, 1, 0);
    EXPECT_NEAR(result.values[0], 1.0 / 20 + 1.0 / 3 + 0.5 + 2, 1e-14);
    EXPECT_NEAR(result.values[1], 31.0 / 5 * 4 + 7.0 * 8 / 3 + 2 + 4, 1e-12);
}

TEST(Cubature, FindsAKinkAndOwnsItsError) {
    const auto f = [](double x, double y) { return std::abs(x - 0.3 * y - 0.2); };
    const Cubature result = integrate(f, {{0, 1, 0, 1}}, 1e-7, 200000);
    // ∫ ((a² + (1−a)²)/2) dy over a = 0.2 + 0.3 y
    const double truth = (0.125 - 0.008) / 0.9 / 2 + (0.512 - 0.125) / 0.9 / 2;
    EXPECT_NEAR(result.total, truth, 1e-7);
    EXPECT_LE(result.error, 1e-7);
}

}  // namespace
}  // namespace plumb::checks
