#include "analytic/cell_weight.h"

#include <gmock/gmock.h>

#include "analytic/cell_weight_exact.h"
#include "core/error.h"
#include "core/random.h"

namespace plumb {
namespace {

TEST(CellWeight, IsOneForOneSample) {
    for (const double x : {0.0, 0x1p-1074, 0.3, 0.5, 1 - 0x1p-53, 1.0}) {
        EXPECT_EQ(cell_weight(1, x), 1);
        EXPECT_EQ(stratified_cell_weight(1, x), 1);
    }
}

TEST(CellWeight, OfTwoSamplesIsAParabola) {
    // g_2 = (1 + 6x − 6x²)/2
    for (const double x : {0.0, 0.125, 0.5, 0.75, 1.0})
        EXPECT_DOUBLE_EQ(cell_weight(2, x), (1 + 6 * x - 6 * x * x) / 2);
}

TEST(CellWeight, IsAHalfAtTheEndsAndOneFarInside) {
    for (const std::uint64_t n : {2ull, 3ull, 100ull, 1'000'000'000ull}) {
        EXPECT_EQ(cell_weight(n, 0), 0.5);
        EXPECT_EQ(cell_weight(n, 1), 0.5);
    }
    EXPECT_EQ(cell_weight(1'000'000'000, 0.5), 1);
}

TEST(CellWeight, KeepsItsPrecisionOverRandomArguments) {
    RandomStream random(1, stream_id("cell weight"));
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto n = static_cast<std::uint64_t>(std::exp(random.uniform() * std::log(1e9)));
        const double scale = std::exp2(-60 * random.uniform());
        const double x = i % 3 == 0   ? random.uniform()
                         : i % 3 == 1 ? scale * random.uniform()
                                      : 1 - scale * random.uniform();
        worst = std::max(worst, cell_weight_ulps(cell_weight(n, x), n, x));
    }
    EXPECT_LE(worst, 8);
    RecordProperty("worst_ulp", std::to_string(worst));
}

TEST(CellWeight, ExactDigits) {
    EXPECT_THAT(exact_cell_weight(2, 0.25, 20), testing::StartsWith("1.0625"));
    // g_3(1/4) = ½[(3 − 1)/16 + (1 − 1) 9/16 + 2] = 17/16
    EXPECT_THAT(exact_cell_weight(3, 0.25, 20), testing::StartsWith("1.0625"));
}

TEST(StratifiedCellWeight, ReachesFromThreeToFiveQuarters) {
    EXPECT_EQ(stratified_cell_weight(4, 0), 0.75);
    EXPECT_EQ(stratified_cell_weight(4, 0.125), 1);
    EXPECT_EQ(stratified_cell_weight(4, 0.25), 1);
    EXPECT_EQ(stratified_cell_weight(4, 0.5), 1);
    EXPECT_EQ(stratified_cell_weight(4, 0.75), 1.25);
    EXPECT_EQ(stratified_cell_weight(4, 0.875), 1);
    EXPECT_EQ(stratified_cell_weight(4, 1), 0.75);
    EXPECT_EQ(stratified_cell_weight(2, 0.5), 1.25);
    // The double 1/3 is less than the third: still in the first stratum, though 3 x rounds to 1.
    EXPECT_EQ(stratified_cell_weight(3, 1.0 / 3), 1.25);
    EXPECT_EQ(stratified_cell_weight(3, std::nextafter(1.0 / 3, 1)), 1);
}

TEST(CellWeight, NamesBadInput) {
    EXPECT_THROW((void)cell_weight(0, 0.5), Error);
    EXPECT_THROW((void)cell_weight(3, -0x1p-1074), Error);
    EXPECT_THROW((void)cell_weight(3, std::nan("")), Error);
    EXPECT_THROW((void)stratified_cell_weight(3, 1 + 0x1p-52), Error);
}

}  // namespace
}  // namespace plumb
