#include "verification/pictures/samples_needed.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

using testing::AllOf, testing::HasSubstr, testing::Not;

constexpr double beta = 0.01, level = 1e-4, infinity = std::numeric_limits<double>::infinity();

/// A difference of many degrees of freedom, against a delta of 1.
MeanDifference difference(double value, double error, double skewness = 0) {
    MeanDifference found{.difference = value, .standard_error = error, .degrees = infinity, .skewness = skewness};
    found.delta = 1;
    const double reach = normal_upper_quantile(beta) * error;
    found.interval = {value - reach, value + reach};
    return found;
}

TEST(MoreSamples, HoldNineTimesInTen) {
    // The interval of half width 2.326 s and the difference, below 1.282 s nine times in ten, must be inside 1.
    const double needed = normal_upper_quantile(0.01) + normal_upper_quantile(0.1);
    EXPECT_NEAR(more_samples(difference(0, 2), 1, level, beta), std::pow(2 * needed, 2), 1e-9);
    EXPECT_NEAR(more_samples(difference(1.5, 2), 1, level, beta), std::pow(2 * needed, 2), 1e-9);  // may be noise
    // A difference that is there takes room.
    EXPECT_NEAR(more_samples(difference(0.9, 0.1), 1, level, beta), std::pow(0.1 * needed / 0.1, 2), 1e-9);
}

TEST(MoreSamples, RefuteWhatIsBeyondWhatIsAllowed) {
    const double needed = normal_upper_quantile(level / 2) + normal_upper_quantile(0.1);
    EXPECT_NEAR(more_samples(difference(3, 1), 1, level, beta), std::pow(needed / 2, 2), 1e-9);
    EXPECT_EQ(more_samples(difference(1, 0.1), 1, level, beta), infinity);  // as large as what is allowed
}

TEST(MoreSamples, KeepTheirPromise) {
    const double n = more_samples(difference(0, 3), 1, level, beta);
    const MeanDifference later = difference(normal_upper_quantile(0.1) * 3 / std::sqrt(n), 3 / std::sqrt(n));
    EXPECT_NEAR(later.interval.high, 1, 1e-9);
}

TEST(MoreSamples, AreNotFewerThanSkewnessAsks) {
    const double z = normal_upper_quantile(beta), skewness = 4;
    const double n = more_samples(difference(0, 0.2, skewness), 1, level, beta);
    EXPECT_NEAR(n, std::pow(skewness * z * z * z / 3, 2), 1e-9);
    EXPECT_TRUE(interval_is_trusted(difference(0, 0.1, skewness / std::sqrt(n) - 1e-9), beta));
}

TEST(MoreSamples, CannotLessenRounding) {
    MeanDifference found = difference(0, 0.5);
    found.interval = {found.interval.low - 0.4, found.interval.high + 0.4};
    const double needed = normal_upper_quantile(0.01) + normal_upper_quantile(0.1);
    EXPECT_NEAR(more_samples(found, 1, level, beta), std::pow(0.5 * needed / 0.6, 2), 1e-9);
    EXPECT_EQ(more_samples(difference(0, 0), 1, level, beta), infinity);
}

MeanDifference needing(double factor) {
    MeanDifference found;
    found.more_samples = factor;
    return found;
}

TEST(SamplesNeeded, AreSaidInSamplesOfAPixel) {
    SamplesNeeded needed;
    EXPECT_EQ(words_of(needed, {}), "");
    needed.add(needing(3), TileState::too_noisy);
    needed.add(needing(11.2), TileState::too_noisy);
    needed.add(needing(500), TileState::same);
    Picture one, other, mute;
    one.samples = 64;
    other.samples = 16;
    EXPECT_EQ(words_of(needed, {&one}), "about 12 times as many samples (720 a pixel) would decide it");
    EXPECT_EQ(words_of(needed, {&one, &other}),
              "about 12 times as many samples (720 and 180 a pixel) of both would decide it");
    EXPECT_EQ(words_of(needed, {&mute}), "about 12 times as many samples would decide it");
}

TEST(SamplesNeeded, ForbidForecastsByTails) {
    SamplesNeeded needed;
    needed.add(needing(30), TileState::heavy_tails);
    EXPECT_EQ(words_of(needed, {}), "tails forbid a forecast: at least 30 times as many samples would be needed");
    needed.add(needing(infinity), TileState::too_noisy);
    EXPECT_EQ(words_of(needed, {}), "no number of samples would decide it");
    needed.add({}, TileState::no_variance);
    EXPECT_EQ(words_of(needed, {}), "how many samples would decide it is not known");
}

}  // namespace
}  // namespace plumb
