#pragma once

#include <cstdint>
#include <vector>

#include "verification/run.h"

namespace plumb {

/// The setting in which the samples of a mean verdict are counted, against a test of a fixed size and what no test can
/// beat. The values are uniform, their bounds declared, and delta = sigma/50: small enough for costs to scale with
/// (sigma/delta)².
struct CostSetting {
    double alpha = 1e-4 / 150;  ///< a typical share of the default budget
    double beta = 0.01;
    std::uint64_t replicates = 400;  ///< simulated verdicts a row
    static constexpr double delta_over_sigma = 0.02;
};

/// The cost of verdicts at one bias: the mean over simulated runs, with the shares of outcomes.
struct CostOfAVerdict {
    double bias = 0;  ///< r, in units of delta
    double mean_samples = 0, standard_error = 0;
    double fraction =
        0;  ///< of the fixed design with the same risks, n_f = (z_(1−alpha/2) + z_(1−beta))² (sigma/delta)²
    double wald = 0;  ///< the least that a sequential test with these risks can need on average, as such a fraction
    double holds = 0, refuted = 0, undecided = 0;  ///< shares of the verdicts
    double fixed_1e5 = 0, fixed_1e6 = 0;  ///< probability that a z-test of that many samples at the 1 % level rejects
};

/// The number of samples of one simulated verdict and how it ended.
struct SimulatedCost {
    double samples = 0;
    bool holds = false, refuted = false;
};
SimulatedCost simulate_verdict(const CostSetting& setting, double bias, RandomStream& random);

/// The number of samples of the fixed design.
double fixed_design(const CostSetting& setting);
/// The number of samples after which a simulated verdict is undecided.
double longest_verdict();

/// The costs, one row for each bias.
std::vector<CostOfAVerdict> cost_of_a_verdict(const CostSetting& setting, const std::vector<double>& biases,
                                              const Run& run);

}  // namespace plumb
