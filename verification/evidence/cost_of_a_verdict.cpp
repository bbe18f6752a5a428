#include "verification/evidence/cost_of_a_verdict.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/moments.h"
#include "core/parallel.h"
#include "verification/evidence/betting.h"
#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

constexpr double sigma_over_delta = 1 / CostSetting::delta_over_sigma;

// Probability that |Z + shift| exceeds the two-sided quantile of the level.
double fixed_test_rejects(double samples, double bias, double level) {
    const double z = normal_upper_quantile(level / 2), shift = bias * std::sqrt(samples) / sigma_over_delta;
    const auto above = [](double x) { return 0.5 * std::erfc(x / std::numbers::sqrt2); };
    return above(z - shift) + above(z + shift);
}

// Wald's bound on the mean of samples, for normal values: with a bias of r delta the log-likelihood ratio of the
// claim's nearest rival grows by r²/2 (delta/sigma)² a sample. At bias 0 the rival is ±delta, and one of the two must
// go first.
// In between a test may end either way, and neither bound applies: NaN.
double wald_bound(const CostSetting& setting, double bias) {
    if (bias > 0 && bias < 1) return std::numeric_limits<double>::quiet_NaN();
    const double rate = bias == 0 ? 0.5 : bias * bias / 2;
    return -std::log(bias == 0 ? setting.beta : setting.alpha) / rate * sigma_over_delta * sigma_over_delta;
}

}  // namespace

double fixed_design(const CostSetting& setting) {
    const double z = normal_upper_quantile(setting.alpha / 2) + normal_upper_quantile(setting.beta);
    return z * z * sigma_over_delta * sigma_over_delta;
}

double longest_verdict() {
    return 200 * sigma_over_delta * sigma_over_delta;
}

// One verdict in units of delta: values uniform in bias ± sqrt(3) sigma, claimed to have mean 0.
SimulatedCost simulate_verdict(const CostSetting& setting, double bias, RandomStream& random) {
    const double half = std::numbers::sqrt3 * sigma_over_delta;
    const Interval bounds{bias - half, bias + half};
    MeanTest test({{0, 0}, {-1, 1}, 1, bounds, setting.alpha, setting.beta, 0});
    const auto cap = static_cast<std::uint64_t>(longest_verdict());
    std::array<double, MeanTest::largest_block> block{};
    auto decision = MeanTest::Decision::none;
    while (decision == MeanTest::Decision::none && test.moments().count() < cap) {
        const auto values = std::span(block).first(test.block_size());
        for (double& x : values) x = bias + half * (2 * random.uniform() - 1);
        decision = test.add(values);
    }
    return {static_cast<double>(test.moments().count()), decision == MeanTest::Decision::holds,
            decision == MeanTest::Decision::refuted};
}

std::vector<CostOfAVerdict> cost_of_a_verdict(const CostSetting& setting, const std::vector<double>& biases,
                                              const Run& run) {
    std::vector<CostOfAVerdict> rows;
    for (const double bias : biases) {
        const Run part = run.part(fmt::format("r={}", bias));
        std::vector<SimulatedCost> costs(setting.replicates);
        for_batches(costs.size(), [&](std::size_t i) {
            RandomStream random = part.random(i);
            costs[i] = simulate_verdict(setting, bias, random);
        });
        Moments samples;
        CostOfAVerdict& row = rows.emplace_back();
        for (const SimulatedCost& cost : costs) {
            samples.add(cost.samples);
            row.holds += cost.holds / static_cast<double>(costs.size());
            row.refuted += cost.refuted / static_cast<double>(costs.size());
        }
        row.bias = bias;
        row.mean_samples = samples.mean();
        row.standard_error = samples.standard_error();
        row.undecided = std::max(1 - row.holds - row.refuted, 0.0);
        row.fraction = samples.mean() / fixed_design(setting);
        row.wald = wald_bound(setting, bias) / fixed_design(setting);
        row.fixed_1e5 = fixed_test_rejects(1e5, bias, 0.01);
        row.fixed_1e6 = fixed_test_rejects(1e6, bias, 0.01);
    }
    return rows;
}

}  // namespace plumb
