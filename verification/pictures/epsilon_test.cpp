// The allowance of a comparison: a deviation that refutes nothing.

#include <gtest/gtest.h>

#include "verification/evidence/distributions.h"
#include "verification/pictures/image_comparison.h"
#include "verification/pictures/synthetic_render.h"

namespace plumb {
namespace {

using Colour = SyntheticRender::Colour;

Picture picture(const SyntheticRender& render, std::uint64_t seed) {
    return picture_of(std::vector{render(seed)}, std::vector<std::string>{"render"});
}

/// A picture that is off by a factor, in a part of it or in all.
SyntheticRender off_by(double factor, int columns = 48) {
    return {.width = 48,
            .height = 48,
            .samples = 1,
            .truth =
                [=](int x, int y) {
                    const double f = x < columns ? factor : 1;
                    return Colour{f * (0.2 + 0.01 * x), f * 0.5, f * (0.1 + 0.01 * y)};
                },
            .law = [](RandomStream& random, int, int) { return 0.8 + 0.4 * random.uniform(); }};
}

Outcome outcome(double factor, double epsilon, std::uint64_t seed, int columns = 48) {
    return compare(picture(off_by(factor, columns), 2 * seed), picture(off_by(1), 2 * seed + 1),
                   {.delta = 0.02, .epsilon = epsilon})
        .verdict.outcome;
}

TEST(Epsilon, AllowsDeviationsUpToIt) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        EXPECT_EQ(outcome(1.01, 0, seed), Outcome::refuted);
        EXPECT_EQ(outcome(1.01, 0.011, seed), Outcome::holds);
        EXPECT_EQ(outcome(0.99, 0.011, seed), Outcome::holds);
    }
}

TEST(Epsilon, RefutesWhatIsBeyondIt) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        EXPECT_EQ(outcome(1.03, 0.01, seed), Outcome::refuted);
        EXPECT_EQ(outcome(0.97, 0.01, seed), Outcome::refuted);
        EXPECT_EQ(outcome(1.3, 0.01, seed, 8), Outcome::refuted);  // a row of tiles
    }
}

TEST(Epsilon, IsNoPartOfWhatHolds) {
    // Off by 3 %: allowed, so not refuted; but not within delta, 2 %.
    for (std::uint64_t seed = 1; seed <= 3; ++seed) EXPECT_EQ(outcome(1.03, 0.04, seed), Outcome::undecided);
}

/// At the edge of what is allowed honest pairs are refuted at most at the level.
TEST(Epsilon, KeepsTheLevelAtItsEdge) {
    constexpr double alpha = 0.05, epsilon = 0.01;
    std::uint64_t refuted = 0;
    constexpr int pairs = 60;
    for (std::uint64_t seed = 0; seed < pairs; ++seed)
        refuted += compare(picture(off_by(1 + epsilon), 2 * seed), picture(off_by(1), 2 * seed + 1),
                           {.alpha = alpha, .epsilon = epsilon})
                       .verdict.outcome == Outcome::refuted;
    EXPECT_LT(clopper_pearson(refuted, pairs, 1e-3).low, alpha);
}

}  // namespace
}  // namespace plumb
