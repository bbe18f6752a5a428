#include "analytic/cell_weight_density.h"

#include <gtest/gtest.h>

#include "analytic/cell_weight.h"
#include "core/error.h"

namespace plumb {
namespace {

const Density1D uniform{[](double) { return 1.0; }, [](double x) { return x; }, 1, 0, 0};
const Density1D ramp{[](double x) { return 0.5 + x; }, [](double x) { return x * (1 + x) / 2; }, 1.5, 1, 1};

TEST(CellWeightOfADensity, UniformReproducesTheClosedForm) {
    for (const std::uint64_t n : {1ull, 2ull, 5ull, 16ull, 100ull})
        for (const double x : {0.0, 0.01, 0.3, 0.5, 0.9, 1.0}) {
            const BoundedValue g = cell_weight_by_quadrature(n, x, uniform, 4096);
            EXPECT_LE(std::abs(g.value - cell_weight(n, x)), g.error + 1e-12) << n << " " << x;
            EXPECT_NEAR(piecewise_cell_weight(n, x, StepDensity::equal_pieces({1, 1, 1})), cell_weight(n, x), 1e-12);
        }
}

TEST(CellWeightOfADensity, QuadratureAgreesWithThePiecewiseClosedForm) {
    const StepDensity steps({0, 0.2, 0.7, 1}, {0.5, 0.2, 0.3});  // densities 2.5, 0.4, 1
    const Density1D density{[&](double x) { return steps.pdf(x); }, [&](double x) { return steps.invert(x); }, 2.5, 2.7,
                            std::numeric_limits<double>::infinity()};
    for (const std::uint64_t n : {2ull, 8ull})
        for (const double x : {0.0, 0.1, 0.2, 0.35, 0.7, 0.99, 1.0}) {
            const BoundedValue g = cell_weight_by_quadrature(n, x, density, 2000);
            EXPECT_LE(std::abs(g.value - piecewise_cell_weight(n, x, steps)), g.error + 1e-12) << n << " " << x;
        }
    EXPECT_THROW(CellWeightTable(4, density, 1e-3), Error);
}

TEST(CellWeightOfADensity, IsOneForOneSampleAndAveragesToOne) {
    EXPECT_NEAR(cell_weight_by_quadrature(1, 0.3, ramp, 1).value, 1, 1e-15);
    // ∫ g p = E Σ |V_i| = 1
    for (const std::uint64_t n : {2ull, 7ull}) {
        double sum = 0;
        for (int i = 0; i < 400; ++i) {
            const double x = (i + 0.5) / 400;
            sum += cell_weight_by_quadrature(n, x, ramp, 400).value * ramp.pdf(x) / 400;
        }
        EXPECT_NEAR(sum, 1, 1e-3);
    }
}

TEST(CellWeightTable, KeepsItsBound) {
    for (const std::uint64_t n : {2ull, 4ull, 8ull}) {
        const CellWeightTable table(n, ramp, 1e-3);
        EXPECT_LE(table.error_bound(), 1e-3);
        for (int i = 0; i <= 97; ++i) {
            const double x = i / 97.0;
            const BoundedValue g = cell_weight_by_quadrature(n, x, ramp, 4000);
            EXPECT_LE(std::abs(table(x) - g.value), table.error_bound() + g.error) << n << " " << x;
        }
    }
}

TEST(CellWeightTable, RefusesWhatItCannotAfford) {
    EXPECT_THROW(CellWeightTable(10000, ramp, 1e-6), Error);
}

}  // namespace
}  // namespace plumb
