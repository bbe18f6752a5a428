#include "verification/evidence/convergence.h"

#include <gtest/gtest.h>

#include <vector>

#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

TEST(SubtractVarianceOfTruth, LeavesAnIntervalOfTheMse) {
    constexpr double bias = 0.5, mse = 1 + bias * bias, variance = 0.02;
    int covered = 0, bias_covered = 0;
    for (std::uint64_t trial = 0; trial < 400; ++trial) {
        RandomStream random(trial);
        const auto normal = [&] { return normal_upper_quantile(random.uniform()); };
        std::vector<Estimate> replicates;
        for (int i = 0; i < 1000; ++i) replicates.push_back({bias + normal(), 0, 1});
        ConvergencePoint point = convergence_point(1, replicates, std::sqrt(variance) * normal());
        subtract_variance_of_truth(point, {variance, variance});
        covered += point.mse_interval.contains(mse) ? 1 : 0;
        bias_covered += std::abs(point.bias - bias) < 1.96 * point.bias_standard_error ? 1 : 0;
    }
    // These are of 380; errors that are products of normal ones reach a little farther. 206, if only the replicates'
    // counted.
    EXPECT_GT(covered, 350);
    EXPECT_LT(covered, 396);
    EXPECT_GT(bias_covered, 362);
    EXPECT_LT(bias_covered, 396);
}

TEST(SubtractVarianceOfTruth, LeavesNoSlopeWhereNothingIsLeft) {
    ConvergencePoint point = convergence_point(1, std::vector<Estimate>{{1.1}, {0.9}, {1.05}}, 1);
    subtract_variance_of_truth(point, {0.1, 0.2});
    EXPECT_LT(point.mse, 0);
    EXPECT_TRUE(std::isnan(point.log_mse_error));
    EXPECT_TRUE(point.mse_interval.contains(0));
}

}  // namespace
}  // namespace plumb
