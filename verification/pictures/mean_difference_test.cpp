#include "verification/pictures/mean_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

Picture grey(int width, double mean, double variance, double degrees) {
    const auto n = static_cast<std::size_t>(width);
    return {.width = width,
            .height = 1,
            .channels = {"Y"},
            .mean = std::vector<double>(n, mean),
            .variance = std::vector<double>(n, variance),
            .degrees = degrees};
}

MeanDifference difference(const Picture& a, const Picture& b, double spike = 0) {
    const DifferenceSums sums = sums_of(a, b, {0, 0, a.width, 1}, 0);
    return difference_of(sums, sums, {.degrees_a = a.degrees, .degrees_b = b.degrees, .spike = spike});
}

TEST(MeanDifference, OfOnePixelIsWelchsTest) {
    const MeanDifference found = difference(grey(1, 5, 2, 3), grey(1, 3, 0, std::numeric_limits<double>::infinity()));
    EXPECT_EQ(found.degrees, 3);  // of the only variance
    EXPECT_NEAR(normal_two_sided_tail(found.z), student_two_sided_tail(2 / std::sqrt(2), 3), 1e-12);
}

TEST(MeanDifference, GainsDegreesOfFreedomFromPixels) {
    // 64 pixels of two equal variances of ν degrees each: 128 variances, 128 (ν + 2) − 2.
    EXPECT_NEAR(difference(grey(64, 5, 2, 3), grey(64, 5, 2, 3)).degrees, 128 * 5 - 2, 1e-9);
}

TEST(MeanDifference, OfKnownNumbersIsEquality) {
    const Picture one = grey(2, 1, 0, 15), other = grey(2, 1.5, 0, 15);
    EXPECT_EQ(difference(one, one).p_value, 1);
    EXPECT_EQ(difference(one, other).p_value, 0);
}

TEST(MeanDifference, OfPixelsThatNeverVariedIsAsLikelyAsThatSpikesWereMissed) {
    Picture a = grey(64, 1, 0, 15), b = grey(64, 1, 0, 15);
    EXPECT_EQ(difference(a, b).p_value, 1);
    b.mean[3] = 1.01;
    EXPECT_EQ(difference(a, b).p_value, 0);  // no pixel anywhere varies
    EXPECT_NEAR(difference(a, b, 0.005).p_value, std::exp(-2), 1e-3);
    EXPECT_NEAR(difference(a, b, 0.005).interval.high, (-0.01 - 0.005 * std::log(0.01)) / 64, 1e-6);
}

TEST(MeanDifference, SeesASpike) {
    Picture a = grey(64, 0, 0.01, 15), b = grey(64, 0, 0.01, 15);
    EXPECT_LT(difference(a, b).skewness, 0.01);
    a.mean[10] = 10;  // one of its replicates had it
    a.variance[10] = 100;
    EXPECT_GT(difference(a, b).skewness, 0.9);
    EXPECT_FALSE(interval_is_trusted(difference(a, b), 0.01));
}

TEST(SkewedPValue, IsTheNormalOneWithoutSkewness) {
    EXPECT_EQ(skewed_p_value(3, 0), normal_two_sided_tail(3));
}

TEST(SkewedPValue, IsCramersToThirdOrder) {
    const double skewness = 1e-4, z = 6;
    EXPECT_NEAR(skewed_p_value(z, skewness) / normal_two_sided_tail(z), std::exp(skewness * z * z * z / 3), 1e-5);
}

TEST(SkewedPValue, NeverPassesTheProbabilityOfNoSpike) {
    for (const double skewness : {0.15, 0.25, 0.5})
        EXPECT_GT(skewed_p_value(1e9, skewness), 0.01 * std::exp(-1 / (skewness * skewness))) << skewness;
}

}  // namespace
}  // namespace plumb
