#include "verification/check.h"

#include <gtest/gtest.h>

#include <memory>

#include "verification/claim.h"

namespace plumb {
namespace {

using testing::ElementsAre;

// A check that says what it was given.
Verdict names(const std::string& subject, const Run& run) {
    Verdict verdict;
    verdict.reason = subject + (run.size() == Size::quick ? ", quick" : ", full");
    return verdict;
}

const Run quick(1, "id", 1e-6), full(1, "id", 1e-6, Size::full);

TEST(Trial, JudgesRightAndWrongSubjectsByTheSameCheck) {
    const Trial trial{names, "right", {{"first", "A defect.", "wrong"}, {"second", "Another.", "worse"}}};
    EXPECT_EQ(trial.judge(quick).reason, "right, quick");
    ASSERT_EQ(trial.mutants().size(), 2u);
    EXPECT_EQ(trial.mutants()[0].id, "first");
    EXPECT_EQ(trial.mutants()[0].defect, "A defect.");
    EXPECT_EQ(trial.mutants()[0].judge(quick).reason, "wrong, quick");
    EXPECT_EQ(trial.mutants()[1].judge(full).reason, "worse, full");
}

TEST(Trial, TakesAnyCallableAndBindsWhatIsShared) {
    const int shared = 3;
    const auto check = [shared](const std::function<int(int)>& f, const plumb::Run&) {
        Verdict verdict;
        verdict.samples = static_cast<std::uint64_t>(f(shared));
        return verdict;
    };
    const Trial trial{check, [](int x) { return x; }, {{"twice", "Doubled.", [](int x) { return 2 * x; }}}};
    EXPECT_EQ(trial.judge(quick).samples, 3u);
    EXPECT_EQ(trial.mutants()[0].judge(quick).samples, 6u);
}

TEST(Trial, OfACheckThatDrawsNothing) {
    const auto check = [](std::uint64_t n) { return Verdict{.samples = n}; };
    const Trial trial{check, 1, {{"two", "Two for one.", 2}}};
    EXPECT_EQ(trial.judge(quick).samples, 1u);
    EXPECT_EQ(trial.mutants()[0].judge(quick).samples, 2u);
}

TEST(Trial, OfACheckWithoutSubjectHasNoMutants) {
    const Trial trial{[](const plumb::Run&) { return Verdict{.samples = 7}; }};
    EXPECT_EQ(trial.judge(quick).samples, 7u);
    EXPECT_TRUE(trial.mutants().empty());
}

TEST(Trial, KeepsItsSubjectsByValue) {
    Trial trial;
    EXPECT_FALSE(trial);
    {
        std::string subject = "mine";
        trial = Trial(names, subject);
        subject = "changed";
    }
    EXPECT_TRUE(trial);
    EXPECT_EQ(trial.judge(quick).reason, "mine, quick");
}

TEST(Catalogue, RefusesAnEmptyTrial) {
    Catalogue catalogue;
    EXPECT_THROW(catalogue.add({.id = "a", .statement = "b", .source = "c", .no_mutant = "d"}), std::logic_error);
}

TEST(Catalogue, RefusesTwoMutantsOfOneId) {
    Catalogue catalogue;
    EXPECT_THROW(catalogue.add({.id = "a",
                                .statement = "b",
                                .source = "c",
                                .trial = {names, "right", {{"x", "One.", "1"}, {"x", "Two.", "2"}}}}),
                 std::logic_error);
}

// A mutant judged by another check than its claim's cannot be written. (That the constructor of Trial refuses what is
// not Judgeable is shown by the test that compiles check_as_subject.cpp.)
static_assert(!Judgeable<Check>);
static_assert(!Judgeable<Verdict (*)(const Run&)>);
static_assert(!Judgeable<std::function<Verdict()>>);
static_assert(!Judgeable<Verdict>);
static_assert(!Judgeable<std::unique_ptr<int>>);  // subjects are copied
static_assert(Judgeable<double> && Judgeable<std::string> && Judgeable<std::function<double(RandomStream&)>>);
static_assert(!std::is_constructible_v<Mutant, std::string, std::string, Check>);
static_assert(!std::is_default_constructible_v<Mutant>);
static_assert(!std::is_constructible_v<Trial, Check, std::vector<Mutant>>);
static_assert(std::is_same_v<decltype(std::declval<Trial&>().mutants()), const std::vector<Mutant>&>);

}  // namespace
}  // namespace plumb
