#include "core/parameters.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "core/error.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::Pair;

const std::vector<Parameter> some{{"budget", "pixels of a pass", Parameter::Real{0.25, 0.01, 1}},
                                  {"heuristic", "of the weights", Parameter::Choice{"power", {"balance", "power"}}},
                                  {"large", "whether all is", Parameter::Flag{false}},
                                  {"roulette-start", "in edges", Parameter::Integer{5, 0, 30000}}};

std::string complaint(const ParameterTexts& given) {
    try {
        require_known(given, some);
        static_cast<void>(Parameters(some, given));
        return "none";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(Parameters, AreTheUsualOnesUnlessGiven) {
    const Parameters usual(some);
    EXPECT_EQ(usual.real("budget"), 0.25);
    EXPECT_EQ(usual.integer("roulette-start"), 5);
    EXPECT_FALSE(usual.flag("large"));
    EXPECT_EQ(usual.choice("heuristic"), "power");
    EXPECT_FALSE(usual.given("budget"));
    const Parameters given(some,
                           {{"budget", "0.5"}, {"large", "yes"}, {"heuristic", "balance"}, {"roulette-start", "0"}});
    EXPECT_EQ(given.real("budget"), 0.5);
    EXPECT_EQ(given.integer("roulette-start"), 0);
    EXPECT_TRUE(given.flag("large"));
    EXPECT_EQ(given.choice("heuristic"), "balance");
    EXPECT_TRUE(given.given("budget"));
}

TEST(Parameters, HaveOneTextEach) {
    EXPECT_THAT(Parameters(some, {{"budget", "5e-1"}}).texts(),
                ElementsAre(Pair("budget", "0.5"), Pair("heuristic", "power"), Pair("large", "no"),
                            Pair("roulette-start", "5")));
    EXPECT_EQ(usual_of(some[0]), "0.25");
    EXPECT_EQ(usual_of(some[2]), "no");
    EXPECT_EQ(Parameters(some, Parameters(some, {{"budget", "0.1"}}).texts()).real("budget"), 0.1);
}

TEST(Parameters, SayWhatIsAccepted) {
    EXPECT_EQ(complaint({{"budget", "2"}}), "parameter budget is '2'; accepted are 0.01 to 1");
    EXPECT_EQ(complaint({{"budget", "half"}}), "parameter budget is 'half'; accepted are 0.01 to 1");
    EXPECT_EQ(complaint({{"budget", "nan"}}), "parameter budget is 'nan'; accepted are 0.01 to 1");
    EXPECT_EQ(complaint({{"roulette-start", "1.5"}}), "parameter roulette-start is '1.5'; accepted are 0 to 30000");
    EXPECT_EQ(complaint({{"large", "1"}}), "parameter large is '1'; accepted are yes or no");
    EXPECT_EQ(complaint({{"heuristic", ""}}), "parameter heuristic is ''; accepted are balance or power");
    EXPECT_EQ(complaint({{"rouletestart", "1"}}), "unknown parameter 'rouletestart'; did you mean 'roulette-start'?");
    EXPECT_EQ(complaint({}), "none");
    EXPECT_THROW(require_known({{"budget", "1"}}, {}), Error);
}

TEST(Parameters, AreReadFromNameAndValue) {
    EXPECT_THAT(parse_parameter("a=b=c"), Pair("a", "b=c"));
    EXPECT_THAT(parse_parameter("a="), Pair("a", ""));
    EXPECT_THROW(parse_parameter("a"), Error);
    EXPECT_THROW(parse_parameter("=1"), Error);
}

TEST(Parameters, OfAnotherKindAreAMistakeOfTheProgram) {
    EXPECT_THROW(static_cast<void>(Parameters(some).integer("budget")), std::logic_error);
    EXPECT_THROW(static_cast<void>(Parameters(some).real("none")), std::logic_error);
}

}  // namespace
}  // namespace plumb
