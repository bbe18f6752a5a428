#include "verification/runner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "core/error.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"

namespace plumb {
namespace {

Verdict uniform_mean(double reference, const Run& run) {
    const auto draw = [](RandomStream& random) { return random.uniform(); };
    return mean_is(draw, {.reference = reference, .delta = 0.02, .bounds = {0, 1}}, run);
}

Claim claim(std::string id, Verdict (*check)(double, const Run&) = uniform_mean) {
    return {.id = std::move(id),
            .statement = "a statement",
            .source = "ours",
            .kind = Kind::mean,
            .trial = {check, 0.5, {{"shifted", "the mean is 5 % off", 0.55}}}};
}

Catalogue toy() {
    Catalogue catalogue;
    catalogue.add(claim("toy/uniform/mean"));
    catalogue.add(claim("toy/other/mean"));
    catalogue.add({.id = "sum/exact",
                   .statement = "1 + 1 = 2",
                   .source = "ours",
                   .kind = Kind::exact,
                   .trial = [](const Run&) { return exactly(1 + 1 == 2, 1, "equal"); },
                   .no_mutant = "arithmetic"});
    return catalogue;
}

const Progress silent = [](const Judged&, std::size_t, std::size_t) {};

TEST(Judge, JudgesClaimsAndMutantsInCatalogueOrder) {
    const Catalogue catalogue = toy();
    const std::vector<Judged> judged = judge(catalogue, {.seed = 5}, silent);
    ASSERT_EQ(judged.size(), 5u);
    EXPECT_EQ(judged[0].id(), "toy/uniform/mean");
    EXPECT_EQ(judged[0].verdict.outcome, Outcome::holds);
    EXPECT_EQ(judged[1].id(), "toy/uniform/mean/shifted");
    EXPECT_EQ(judged[1].verdict.outcome, Outcome::refuted);
    EXPECT_EQ(judged[4].verdict.outcome, Outcome::holds);
}

TEST(Judge, AVerdictDependsNeitherOnThreadsNorOnTheSelection) {
    const Catalogue catalogue = toy();
    const std::vector<Judged> all = judge(catalogue, {.seed = 5, .threads = 2}, silent);
    const std::vector<Judged> one = judge(catalogue, {.seed = 5, .patterns = {"toy/oth*"}, .threads = 1}, silent);
    ASSERT_EQ(one.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(one[i].verdict.reason, all[2 + i].verdict.reason);
        EXPECT_EQ(one[i].verdict.samples, all[2 + i].verdict.samples);
        EXPECT_EQ(one[i].verdict.p_value, all[2 + i].verdict.p_value);
    }
}

TEST(Judge, APatternWithoutAMatchIsAnError) {
    const Catalogue catalogue = toy();
    EXPECT_THROW(judge(catalogue, {.patterns = {"tory/*"}}, silent), Error);
}

TEST(Judge, ACheckThatThrowsIsUndecided) {
    Catalogue catalogue;
    catalogue.add(
        claim("toy/throws", [](double, const plumb::Run&) -> Verdict { throw std::runtime_error("out of luck"); }));
    const std::vector<Judged> judged = judge(catalogue, {}, silent);
    EXPECT_EQ(judged[0].verdict.outcome, Outcome::undecided);
    EXPECT_THAT(judged[0].verdict.reason, testing::HasSubstr("out of luck"));
}

// A claim whose every draw takes a while, and one that is quick.
Catalogue slow_and_quick(std::chrono::milliseconds draw_time) {
    Catalogue catalogue = toy();
    const auto slow = [draw_time](const plumb::Run& run) {
        const auto draw = [draw_time](RandomStream& random) {
            std::this_thread::sleep_for(draw_time);
            return random.uniform();
        };
        return mean_is(draw, {.reference = 0.5, .delta = 1e-3, .bounds = {0, 1}}, run);
    };
    catalogue.add({.id = "slow/mean",
                   .statement = "It takes its time.",
                   .source = "ours",
                   .kind = Kind::mean,
                   .trial = slow,
                   .no_mutant = "a test"});
    return catalogue;
}

TEST(Judge, TheTimeLimitOnlyMakesUndecided) {
    const Catalogue catalogue = slow_and_quick(std::chrono::milliseconds(20));
    const auto start = std::chrono::steady_clock::now();
    const std::vector<Judged> judged =
        judge(catalogue, {.time_limit = std::chrono::milliseconds(300), .threads = 2}, silent);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(800));
    ASSERT_EQ(judged.size(), 6u);
    EXPECT_EQ(judged[5].verdict.outcome, Outcome::undecided);
    EXPECT_THAT(judged[5].verdict.reason, testing::HasSubstr("time limit"));
}

TEST(Judge, AStopDropsWhatIsOpenAndKeepsWhatIsDone) {
    const Catalogue catalogue = slow_and_quick(std::chrono::milliseconds(20));
    std::stop_source stop;
    std::chrono::steady_clock::time_point asked;
    const auto stop_at_last = [&](const Judged&, std::size_t done, std::size_t) {
        if (done < 5) return;
        asked = std::chrono::steady_clock::now();
        stop.request_stop();
    };
    const std::vector<Judged> judged =
        judge(catalogue, {.seed = 5, .stop = stop.get_token(), .threads = 2}, stop_at_last);
    EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::milliseconds(500));
    ASSERT_EQ(judged.size(), 5u);
    EXPECT_EQ(judged[4].id(), "sum/exact");
}

TEST(ShardOf, SplitsClaimsAndMutantsIntoPartsThatMakeUpTheWhole) {
    const Catalogue catalogue = toy();
    const std::vector<Item> all = select(catalogue, Size::quick, {});
    std::vector<std::size_t> positions;
    for (const int index : {1, 2, 3})
        for (const Item& item : shard_of(all, {index, 3})) {
            positions.push_back(item.position);
            EXPECT_EQ(item.id(), all[item.position].id());
        }
    std::ranges::sort(positions);
    EXPECT_EQ(positions, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(shard_of(all, {1, 3}).size(), 2u);
    EXPECT_EQ(shard_of(all, {9, 9}).size(), 0u);
}

TEST(Catalogue, SharesAlphaAmongStatisticalClaims) {
    const Catalogue catalogue = toy();
    EXPECT_EQ(catalogue.share(catalogue.claims()[0], Size::quick), 0.5);
    EXPECT_EQ(catalogue.share(catalogue.claims()[2], Size::quick), 0);
}

TEST(Catalogue, RefusesAClaimWithoutMutantOrReason) {
    Catalogue catalogue = toy();
    EXPECT_THROW(catalogue.add(claim("toy/uniform/mean")), std::logic_error);  // id taken
    Claim bare = claim("toy/bare");
    bare.trial = {uniform_mean, 0.5};
    EXPECT_THROW(catalogue.add(bare), std::logic_error);
}

TEST(Matches, KnowsStarsAndQuestionMarks) {
    EXPECT_TRUE(matches("reweighting/torus/mean", "reweighting/*"));
    EXPECT_TRUE(matches("reweighting/torus/mean", "*/mean"));
    EXPECT_TRUE(matches("abc", "a?c"));
    EXPECT_FALSE(matches("abc", "ab"));
    EXPECT_FALSE(matches("ab", "abc"));
}

}  // namespace
}  // namespace plumb
