#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "core/interval.h"
#include "core/random.h"
#include "verification/evidence/betting.h"

namespace plumb::suites {

// Laws with an exponential tilt, on which the tests are tried. Rates of 1e-6 and less are reached by tilting: the test
// runs under a law under which the rare outcome is common, and the outcome is weighted with the likelihood ratio, which
// keeps the expectation (docs/statistics.md, "Calibration").

constexpr double alpha_in_use = 1e-4 / 150;  ///< a typical share of the default budget
constexpr double beta_in_use = 0.01;
constexpr double aim = 1.3;  ///< a rate may exceed its level by at most this factor

/// A value and its sufficient statistic: log dP_0/dP_theta = b + a t.
struct TiltedValue {
    double x, t;
};
/// A tilt at one theta: the coefficients of log dP_0/dP_theta = b + a t.
struct Tilt {
    double a, b;
};

/// A law with a family of tilts; theta = 0 is the law itself, and theta moves its mean in that direction.
struct TiltedLaw {
    std::string name;
    double mean, sigma;  ///< at theta = 0
    Interval bounds;     ///< of a value
    std::function<Tilt(double theta)> tilt;
    std::function<TiltedValue(double theta, RandomStream&)> draw;
    double delta_over_sigma = 0.2;  ///< of the tests that it is tried on
    std::uint64_t min_samples = 0;

    [[nodiscard]] double delta() const { return delta_over_sigma * sigma; }
    [[nodiscard]] std::uint64_t cap() const {
        return static_cast<std::uint64_t>(100 / (delta_over_sigma * delta_over_sigma));
    }
    [[nodiscard]] TiltedLaw at(double another_delta_over_sigma) const;
    /// The same law with nothing known of the range of its values: then delta must be so small that the guard on
    /// skewness is satisfied by the time the test could decide, n = 14 (sigma/delta)² or so.
    [[nodiscard]] TiltedLaw without_bounds(double smaller_delta_over_sigma, std::uint64_t least_samples) const;
    /// A test of "the mean is `reference`" within delta at the level in use.
    [[nodiscard]] MeanTest test(double reference) const;
};

TiltedLaw bernoulli(double p);
TiltedLaw normal();
TiltedLaw exponential();
TiltedLaw lognormal(double s);  ///< exp(s Z)
/// A value uniform in [0, 1), but larger by 4 … 8 with probability 1/50: skewness 6.
TiltedLaw spikes();

/// The outcome of one simulated run of a test.
struct SimulatedRun {
    bool refuted = false, holds = false;
    double weight = 1;  ///< dP_0 / dP_mixture along the samples used
};

/// Feeds a test with samples of the law tilted by one of `thetas`, chosen at random, until it decides or `cap` samples
/// are used. The weight is against the mixture of all tilts (the balance heuristic), so that no single tilt can spoil
/// it.
template <class Test>
SimulatedRun simulate(Test test, const TiltedLaw& law, const std::vector<double>& thetas, std::uint64_t cap,
                      RandomStream& random) {
    const double theta = thetas[random.below(thetas.size())];
    SimulatedRun run;
    std::array<double, MeanTest::largest_block> block{};
    double sum = 0;
    while (!run.refuted && !run.holds && test.moments().count() < cap) {
        const auto values = std::span(block).first(test.block_size());
        for (double& x : values) {
            const TiltedValue value = law.draw(theta, random);
            x = value.x;
            sum += value.t;
        }
        const MeanTest::Decision decision = test.add(values);
        run.holds = decision == MeanTest::Decision::holds;
        run.refuted = decision == MeanTest::Decision::refuted;
    }
    if (thetas == std::vector{0.0}) return run;
    double inverse = 0;
    for (const double each : thetas) {
        const Tilt tilt = law.tilt(each);
        inverse += std::exp(-tilt.b * static_cast<double>(test.moments().count()) - tilt.a * sum);
    }
    run.weight = static_cast<double>(thetas.size()) / inverse;
    return run;
}

}  // namespace plumb::suites
