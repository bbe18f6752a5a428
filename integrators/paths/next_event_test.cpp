#include "integrators/paths/next_event.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

/// ½ in every slot, of the density 2.
struct Halves final : PrimarySamples {
    Drawn at(Slot) override { return {{0.5, 0.5}, 2}; }
};

TEST(Draws, MultiplyTheirDensities) {
    Halves numbers;
    Draws path(numbers);
    EXPECT_EQ(path.density(), 1);
    path.at({0, Use::film});
    path.at({1, Use::direction});
    Draws beside = path.branch();
    beside.at({1, Use::light});
    EXPECT_EQ(path.density(), 4);
    EXPECT_EQ(beside.density(), 2);
}

TEST(Draws, SamplesOfAVertexHaveSlotsOfTheirOwn) {
    EXPECT_EQ(SampleIndex{3}.slot(Use::light), (Slot{3, Use::light}));
    EXPECT_NE(slot_index({3, Use::light, 1}), slot_index({3, Use::light}));
    EXPECT_NE(slot_index({0, Use::light, 1}), slot_index({1, Use::light}));
}

TEST(PathRecord, DividesSplatsAndWeighsTheFirstHit) {
    PathRecord record;
    record.add({{0, 0}, Spectrum::grey(6), 2}, 4);
    EXPECT_EQ(record.sum(), Spectrum::grey(1.5));
    record.meet({}, 4);
    record.meet({}, 16);
    EXPECT_EQ(record.first_hit_weight, 0.25);
    EXPECT_EQ(record.vertices.size(), 2u);
    record.clear();
    EXPECT_EQ(record.first_hit_weight, 1);
}

TEST(MisWeight, SumsToOneByAnyHeuristic) {
    const std::array densities{0.5, 3.0, 0.0, 3.0, 1e-300};
    for (const MisWeight weight : {mis_weight<Power>, mis_weight<Balance>, mis_weight<Maximum>}) {
        double sum = 0;
        for (std::size_t i = 0; i < densities.size(); ++i) sum += weight(densities, i);
        EXPECT_NEAR(sum, 1, 1e-15);
        EXPECT_EQ(weight(densities, 2), 0);
    }
    EXPECT_EQ(mis_weight<Power>(std::array{0.3, 0.0}, 0), 1);  // of a light that no direction meets
}

TEST(NextEvent, TakesCountsForOneChoiceOfLights) {
    const NextEvent next_event = with_counts({}, {2, 3});
    EXPECT_EQ(next_event.lights.front().count, 2);
    EXPECT_EQ(next_event.bsdf_count, 3);
    EXPECT_THROW(with_counts({}, {-1, 1}), Error);
    NextEvent two;
    two.lights.push_back({uniform_choice(), 1});
    EXPECT_THROW(with_counts(two, one_of_each), Error);
}

TEST(LightChoices, HaveNames) {
    for (const NamedLightChoice& named : light_choices()) {
        EXPECT_FALSE(named.summary.empty()) << named.id;
        EXPECT_TRUE(named.make()) << named.id;
    }
}

}  // namespace
}  // namespace plumb
