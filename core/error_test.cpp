#include "core/error.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

const std::vector<std::string> known = {"torus", "voronoi", "stratified"};

TEST(NearestName, FindsASlipOfTheFinger) {
    EXPECT_EQ(nearest_name("voroni", known), "voronoi");
    EXPECT_EQ(nearest_name("torus", known), "torus");
}

TEST(NearestName, IsSilentWhenNothingIsNear) {
    EXPECT_EQ(nearest_name("metropolis", known), "");
}

TEST(UnknownName, NamesTheThingAndWhatIsAccepted) {
    EXPECT_STREQ(unknown_name("estimator", "tours", known).what(), "unknown estimator 'tours'; did you mean 'torus'?");
    EXPECT_STREQ(unknown_name("estimator", "metropolis", known).what(),
                 "unknown estimator 'metropolis'; known: torus, voronoi, stratified");
}

}  // namespace
}  // namespace plumb
