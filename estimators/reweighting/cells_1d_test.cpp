#include "estimators/reweighting/cells_1d.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/random.h"
#include "estimators/reweighting/reweighting_1d.h"
#include "estimators/reweighting/samples_1d.h"

namespace plumb {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using Samples = std::vector<double>;

double sum(const Samples& weights) {
    long double total = 0;
    for (const double w : weights) total += w;
    return static_cast<double>(total);
}

void expect_partition(const Samples& samples) {
    EXPECT_NEAR(sum(voronoi_weights_1d(samples)), 1, 1e-12);
    EXPECT_NEAR(sum(torus_weights_1d(samples)), 1, 1e-12);
    for (const double w : voronoi_weights_1d(samples)) EXPECT_GE(w, 0);
    for (const double w : torus_weights_1d(samples)) EXPECT_GE(w, 0);
}

TEST(Cells1D, OneSampleHasEverything) {
    for (const double x : {0.0, 0x1p-1074, 0.4, 1 - 0x1p-53, 1.0}) {
        EXPECT_THAT(voronoi_weights_1d(Samples{x}), ElementsAre(1));
        EXPECT_THAT(torus_weights_1d(Samples{x}), ElementsAre(1));
    }
}

TEST(Cells1D, TwoSamplesMeetHalfway) {
    EXPECT_THAT(voronoi_weights_1d(Samples{0.75, 0.25}), ElementsAre(0.5, 0.5));
    EXPECT_THAT(voronoi_weights_1d(Samples{0.5, 0.25}), ElementsAre(0.625, 0.375));
    EXPECT_THAT(torus_weights_1d(Samples{0.5, 0.25}), ElementsAre(0.5, 0.5));
    EXPECT_THAT(torus_weights_1d(Samples{0.5, 0x1p-1074}), ElementsAre(0.5, 0.5));
}

TEST(Cells1D, KeepTheOrderOfTheSamples) {
    EXPECT_THAT(voronoi_weights_1d(Samples{0.75, 0.125, 0.25}), ElementsAre(0.5, 0.1875, 0.3125));
    EXPECT_THAT(torus_weights_1d(Samples{0.75, 0.125, 0.25}), ElementsAre(0.4375, 0.25, 0.3125));
}

TEST(Cells1D, CoincidentSamplesShareTheirCell) {
    EXPECT_THAT(voronoi_weights_1d(Samples{0.25, 0.75, 0.25}), ElementsAre(0.25, 0.5, 0.25));
    EXPECT_THAT(torus_weights_1d(Samples{0.3, 0.3, 0.3, 0.3}), ElementsAre(0.25, 0.25, 0.25, 0.25));
    EXPECT_THAT(voronoi_weights_1d(Samples{1, 1, 1, 1}), ElementsAre(0.25, 0.25, 0.25, 0.25));
}

TEST(Cells1D, ZeroAndOneAreOnePlaceOnTheTorusOnly) {
    EXPECT_THAT(torus_weights_1d(Samples{1, 0.5, 0}), ElementsAre(0.25, 0.5, 0.25));
    EXPECT_THAT(torus_weights_1d(Samples{1, 0.25}), ElementsAre(0.5, 0.5));
    EXPECT_THAT(torus_weights_1d(Samples{1, 1}), ElementsAre(0.5, 0.5));
    EXPECT_THAT(voronoi_weights_1d(Samples{1, 0.5, 0}), ElementsAre(0.25, 0.5, 0.25));
}

TEST(Cells1D, HardCasesStillPartitionTheDomain) {
    RandomStream random(7, stream_id("hard cases"));
    Samples cluster;
    for (int i = 0; i < 10000; ++i) cluster.push_back(0.3 + 1e-12 * random.uniform());
    expect_partition(cluster);
    expect_partition({0x1p-1074, 0x1p-1073, 0x1p-1022, 1 - 0x1p-53, 1 - 0x1p-52});
    expect_partition({0, 1});
    expect_partition({0, 0x1p-1074, 1});
    expect_partition(independent_samples_1d(100000, random));
    expect_partition(jittered_samples_1d(999, random));
}

TEST(Cells1D, TenMillionSamples) {
    RandomStream random(8, stream_id("many"));
    const Samples samples = independent_samples_1d(10'000'000, random);
    EXPECT_NEAR(sum(torus_weights_1d(samples)), 1, 1e-12);
    EXPECT_NEAR(sum(reweighted_weights_1d(samples)), 1, 1e-5);
}

TEST(Cells1D, NameTheBadSample) {
    const auto message_of = [](const Samples& samples) {
        try {
            (void)torus_weights_1d(samples);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(message_of({0.5, std::nan("")}), "sample 1 is nan; samples must lie in [0, 1]");
    EXPECT_EQ(message_of({0.5, 0.1, 1.5}), "sample 2 is 1.5; samples must lie in [0, 1]");
    EXPECT_EQ(message_of({-std::numeric_limits<double>::infinity()}), "sample 0 is -inf; samples must lie in [0, 1]");
    EXPECT_THROW((void)voronoi_weights_1d(Samples{}), Error);
}

}  // namespace
}  // namespace plumb
