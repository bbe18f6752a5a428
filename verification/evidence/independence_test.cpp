#include "verification/evidence/independence.h"

#include <gtest/gtest.h>

#include "verification/evidence/log_mean.h"
#include "verification/evidence/rare_values.h"

namespace plumb {
namespace {

using testing::HasSubstr;

std::string complaint(const std::vector<double>& values) {
    Independence independence;
    independence.add(values);
    return independence.complaint();
}

TEST(Independence, NamesTheCorrelation) {
    RandomStream random(1);
    std::vector<double> values(1000), alone(1000);
    double last = 0;
    for (double& x : values) x = last = 0.8 * last + random.uniform();
    for (double& x : alone) x = random.uniform();
    EXPECT_THAT(complaint(values), HasSubstr("values one apart have the correlation 0."));
    EXPECT_EQ(complaint(alone), "");
}

TEST(Independence, SeesALongPeriodInManyDraws) {
    std::vector<double> list(100'000), values;
    RandomStream random(2);
    for (double& x : list) x = random.uniform();
    for (int period = 0; period < 3; ++period) values.insert(values.end(), list.begin(), list.end());
    EXPECT_THAT(complaint(values), HasSubstr("300,000 of them have about"));
    EXPECT_EQ(complaint(list), "");
}

TEST(RareValues, AreToldInWords) {
    EXPECT_EQ(what_could_hide(65536), "values rarer than 1 in 4,096 could hide");
    EXPECT_EQ(what_could_hide(20), "any value that was not drawn could hide");
    EXPECT_EQ(with_commas(1234567), "1,234,567");
    EXPECT_EQ(with_commas(123), "123");
}

// Squares of normal errors: coefficient of variation √2, skewness √8; ln of their mean has the skewness −√(2/n).
TEST(LogMean, OfSquaresOfNormalErrors) {
    Moments squares;
    RandomStream random(3);
    for (int i = 0; i < 200'000; ++i) {
        const double r2 = -2 * std::log1p(-random.uniform()), c = std::cos(6.283185307179586 * random.uniform());
        squares.add(r2 * c * c);
    }
    const LogMean log = log_mean(squares);
    EXPECT_NEAR(log.standard_error * std::sqrt(2e5), std::sqrt(2.0), 0.03);
    EXPECT_NEAR(log.skewness * std::sqrt(2e5), std::sqrt(8.0) / 3 - std::sqrt(0.5), 0.1);
    EXPECT_NEAR(log.kurtosis * 24 * 2e5, 12, 3);
    EXPECT_NEAR(log_ratio(log, log).skewness, 0, 1e-12);
}

TEST(LogMean, MovesItsQuantileOutByItsDistortionThere) {
    const LogMean skew{.value = 0, .standard_error = 1, .skewness = 0.005, .kurtosis = 1e-4};
    const double moved = skew.quantile(4.5);
    EXPECT_GT(moved, 4.5);
    EXPECT_NEAR(moved * moved / 2 - skew.distortion(moved), 4.5 * 4.5 / 2, 1e-4);
    EXPECT_EQ((LogMean{.value = 0, .standard_error = 1}.quantile(4.5)), 4.5);
    EXPECT_EQ((LogMean{.value = 0, .standard_error = 1, .skewness = 0.1}.quantile(4.5)), HUGE_VAL);
}

}  // namespace
}  // namespace plumb
