#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "analytic/rational.h"

namespace plumb {

/// The exact expectation and variance of an estimator, and how many outcomes they are from.
struct ExactMoments {
    Rational mean, variance;
    std::uint64_t outcomes = 0;  ///< leaves of the decision tree with positive probability
};

/// Discrete randomness that is followed through every outcome instead of drawn. An estimator written over its source of
/// randomness (`random.below(n)`, as RandomStream has it) runs on either; replayed with all outcomes of all its
/// choices, it has an exact expectation.
class Choices {
public:
    /// Each of 0 … n−1 with probability 1/n; n ≥ 1.
    std::uint64_t below(std::uint64_t n);
    /// i with probability probabilities[i]; they are ≥ 0 and sum to exactly 1. Impossible outcomes are not visited.
    std::size_t choose(std::span<const Rational> probabilities);
    /// True with probability p in [0, 1].
    bool chance(const Rational& p);

private:
    friend ExactMoments enumerate(const std::function<Rational(Choices&)>& estimator, std::uint64_t most_outcomes);
    struct Choice {
        std::size_t taken, options;
    };
    std::size_t take(std::size_t options);
    void rewind();
    bool advance();  ///< depth first: the last unfinished choice moves one option on; false when all are finished

    std::vector<Choice> path_;  ///< the branch of the decision tree that is being replayed
    std::size_t depth_ = 0;     ///< how many of its choices have been made in this replay
    Rational probability_ = 1;  ///< of the choices made so far
};

/// Expectation and variance of the estimator over every outcome of its choices, exactly. The estimator is a pure
/// function of its choices, each branch ends, and there are at most `most_outcomes` of them: else Error.
ExactMoments enumerate(const std::function<Rational(Choices&)>& estimator, std::uint64_t most_outcomes = 10'000'000);

}  // namespace plumb
