#include "checks/sampler/uniformity.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace plumb::checks {
namespace {

constexpr int samples = 40'000;

template <class Map>
Uniformity of(const Map& map, std::uint64_t seed = 1) {
    Uniformity counts;
    RandomStream random(seed);
    for (int i = 0; i < samples; ++i) counts.add(map(random.uniform()));
    return counts;
}

TEST(Uniformity, RefutesTrueSamplersNoMoreOftenThanItSays) {
    int cumulative = 0, dyadic = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Uniformity counts = of([](double u) { return u; }, seed);
        cumulative += counts.cumulative().p_value < 0.05;
        dyadic += counts.dyadic().p_value < 0.05;
    }
    EXPECT_LE(cumulative, 25);  // 10 are expected, 25 or more with probability 4e-5
    EXPECT_LE(dyadic, 10);
}

TEST(Uniformity, FindsWhereSamplesPileUp) {
    const Uniformity counts = of([](double u) { return u > 0.5 && u < 0.52 ? u * 1e-4 : u; });  // 2 % go near 0
    EXPECT_LT(counts.cumulative().p_value, 1e-6);
    const Unevenness worst = counts.dyadic();
    EXPECT_LT(worst.p_value, 1e-6);
    EXPECT_EQ(worst.low, 0);
    EXPECT_LT(worst.high, 1e-3);
    EXPECT_NEAR(worst.found, 0.02, 0.003);
}

TEST(Uniformity, FindsAGap) {
    const Unevenness worst = of([](double u) { return u > 0.25 && u < 0.2505 ? u + 0.3 : u; }).dyadic();
    EXPECT_LT(worst.p_value, 1e-3);
    EXPECT_EQ(worst.low, 0.25);
    EXPECT_EQ(worst.found, 0);
}

}  // namespace
}  // namespace plumb::checks
