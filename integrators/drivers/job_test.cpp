#include "integrators/drivers/job.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

std::pair<std::uint32_t, std::uint32_t> cut(const char* sampler, std::uint32_t samples) {
    const RenderSettings settings = with_samples({.sampler = sampler}, samples);
    return {settings.passes, settings.samples_per_pass};
}

using Cut = std::pair<std::uint32_t, std::uint32_t>;

TEST(WithSamples, CutsIndependentOnesNearSixteenPasses) {
    EXPECT_EQ(cut("independent", 64), (Cut{16, 4}));
    EXPECT_EQ(cut("independent", 16), (Cut{16, 1}));
    EXPECT_EQ(cut("independent", 17), (Cut{17, 1}));
    EXPECT_EQ(cut("independent", 24), (Cut{12, 2}));
    EXPECT_EQ(cut("independent", 1), (Cut{1, 1}));
}

TEST(WithSamples, GivesSetsSeveralPoints) {
    for (const char* sampler : {"sobol", "sobol-owen", "stratified"}) {
        EXPECT_EQ(cut(sampler, 4), (Cut{2, 2}));
        EXPECT_EQ(cut(sampler, 6), (Cut{3, 2}));
        EXPECT_EQ(cut(sampler, 8), (Cut{4, 2}));
        EXPECT_EQ(cut(sampler, 16), (Cut{4, 4}));
        EXPECT_EQ(cut(sampler, 20), (Cut{5, 4}));
        EXPECT_EQ(cut(sampler, 22), (Cut{11, 2}));
        EXPECT_EQ(cut(sampler, 25), (Cut{5, 5}));
    }
}

TEST(WithSamples, TakesOneMoreThanAPrime) {
    EXPECT_EQ(cut("sobol", 5), (Cut{3, 2}));
    EXPECT_EQ(cut("sobol", 17), (Cut{6, 3}));
    EXPECT_EQ(cut("sobol", 251), (Cut{18, 14}));
}

TEST(WithSamples, LeavesAsTheyAreWhereSetsHaveSeveralPoints) {
    for (std::uint32_t samples = 1; samples <= 1000; ++samples) {
        const Cut independent = cut("independent", samples), sets = cut("sobol", samples);
        if (independent.second > 1 || samples < 4) {
            EXPECT_EQ(sets, independent) << samples;
            continue;
        }
        EXPECT_GE(sets.second, 2U) << samples;
        EXPECT_GE(sets.first, sets.second) << samples;
        const std::uint32_t taken = sets.first * sets.second;
        EXPECT_TRUE(taken == samples || taken == samples + 1) << samples;
    }
}

}  // namespace
}  // namespace plumb
