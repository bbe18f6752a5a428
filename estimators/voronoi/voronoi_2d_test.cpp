#include "estimators/voronoi/voronoi_2d.h"

#include <gmock/gmock.h>

#include <numeric>

#include "core/random.h"
#include "estimators/voronoi/voronoi_brute_force.h"
#include "estimators/voronoi/voronoi_hard_sets.h"

namespace plumb {
namespace {

using testing::Each;
using testing::Ge;
using testing::HasSubstr;
using testing::ThrowsMessage;

double sum(const std::vector<double>& weights) {
    return std::accumulate(weights.begin(), weights.end(), 0.0);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

TEST(VoronoiAreas, OfOneSampleIsTheWholeDomain) {
    EXPECT_EQ(voronoi_areas(std::vector<Point<2>>{{0.3, 0}}), std::vector{1.0});
    EXPECT_EQ(voronoi_areas_periodic(std::vector<Point<2>>{{0.25, 0}}), std::vector{1.0});
}

TEST(VoronoiAreas, OfTwoSamplesAreCutByTheirBisector) {
    const std::vector<Point<2>> samples{{0.125, 0.5}, {0.375, 0.5}};
    EXPECT_THAT(voronoi_areas(samples), testing::ElementsAre(0.25, 0.75));
    EXPECT_THAT(voronoi_areas_periodic(samples), Each(testing::DoubleNear(0.5, 1e-15)));
}

TEST(VoronoiAreas, OfCoincidentSamplesAreShared) {
    const std::vector<Point<2>> samples{{0.25, 0.5}, {0.75, 0.5}, {0.25, 0.5}};
    EXPECT_THAT(voronoi_areas(samples), testing::ElementsAre(0.25, 0.5, 0.25));
}

TEST(VoronoiAreas, AgreeWithBruteForceOnHardSets) {
    for (const HardSet& set : voronoi_hard_sets()) {
        const auto areas = voronoi_areas(set.samples), periodic = voronoi_areas_periodic(set.samples);
        EXPECT_NEAR(sum(areas), 1, 1e-12) << set.name;
        EXPECT_NEAR(sum(periodic), 1, 1e-12) << set.name;
        EXPECT_THAT(areas, Each(Ge(0))) << set.name;
        EXPECT_THAT(periodic, Each(Ge(0))) << set.name;
        if (set.samples.size() > 1000) continue;  // O(N²)
        EXPECT_LT(largest_difference(areas, brute_force_voronoi_areas(set.samples)), 1e-12) << set.name;
        if (!set.separated) continue;
        EXPECT_LT(largest_difference(periodic, brute_force_voronoi_areas_periodic(set.samples)), 1e-12) << set.name;
    }
}

TEST(VoronoiAreas, AgreeWithBruteForceOnRandomSets) {
    RandomStream random(20240607);
    for (std::size_t n = 1; n <= 200; n += n < 20 ? 1 : 30) {
        std::vector<Point<2>> samples(n);
        for (Point<2>& x : samples) x = {random.uniform(), random.uniform()};
        EXPECT_LT(largest_difference(voronoi_areas(samples), brute_force_voronoi_areas(samples)), 1e-14) << n;
        EXPECT_LT(largest_difference(voronoi_areas_periodic(samples), brute_force_voronoi_areas_periodic(samples)),
                  1e-14)
            << n;
    }
}

TEST(VoronoiAreas, KeepRelativeAccuracyInsideACluster) {
    // A grid of 2^-40: the inner cells are 2^-80 each.
    std::vector<Point<2>> samples;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j) samples.push_back({0.625 + i * 0x1p-40, 0.375 + j * 0x1p-40});
    const auto areas = voronoi_areas(samples);
    for (const int inner : {9, 10, 18, 27, 54}) EXPECT_NEAR(areas[inner] * 0x1p80, 1, 1e-12);
}

TEST(VoronoiAreas, DoNotDependOnTheOrderOfTheSamples) {
    RandomStream random(5);
    std::vector<Point<2>> samples(100);
    for (Point<2>& x : samples) x = {random.uniform(), random.uniform()};
    std::vector<Point<2>> reversed(samples.rbegin(), samples.rend());
    auto areas = voronoi_areas(reversed);
    std::ranges::reverse(areas);
    EXPECT_LT(largest_difference(areas, voronoi_areas(samples)), 1e-15);
}

TEST(VoronoiAreas, NameTheSampleThatIsNotInTheSquare) {
    std::vector<Point<2>> samples{{0.5, 0.5}, {0.25, 1}, {0.5, 0.75}};
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, -0x1p-1074, 1 + 0x1p-52}) {
        samples[2][1] = bad;
        EXPECT_THAT([&] { voronoi_areas(samples); }, ThrowsMessage<Error>(HasSubstr("sample 2: coordinate 1 is")));
        EXPECT_THAT([&] { voronoi_areas_periodic(samples); }, ThrowsMessage<Error>(HasSubstr("sample 2")));
    }
    EXPECT_THAT([] { voronoi_areas({}); }, ThrowsMessage<Error>(HasSubstr("no samples")));
}

TEST(VoronoiVolumes, InThreeDimensionsAreAClearError) {
    const std::vector<Point<3>> samples{{0.5, 0.5, 0.5}};
    EXPECT_THAT([&] { voronoi_volumes<3>(samples); }, ThrowsMessage<Error>(HasSubstr("in 3 dimensions")));
}

}  // namespace
}  // namespace plumb
