#include "cli/command_line.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <set>

#include "verification/claim.h"

namespace plumb::cli {
namespace {

template <class... Words>
int run(const std::vector<Verb>& verbs, Words... words) {
    const std::array<const char*, sizeof...(words) + 1> argv = {"plumb", words...};
    return run_verb(static_cast<int>(argv.size()), argv.data(), verbs, Catalogue());
}

// Parses what must fail, and gives the one line on standard error.
template <class... Words>
std::string complaint(Words... words) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(shipped_verbs(), words...), 2);
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(std::ranges::count(text, '\n'), 1) << text;
    return text;
}

// A verb whose exit code says what it read.
Verb count() {
    return {"count", "Counts", [](CLI::App& verb) -> Action {
                const auto apples = std::make_shared<int>(3);
                verb.add_option("--apples", *apples, "how many");
                return [apples](const Catalogue& catalogue) {
                    return *apples + static_cast<int>(catalogue.claims().size());
                };
            }};
}

TEST(RunVerb, GivesTheActionItsOptionsAndTheCatalogue) {
    EXPECT_EQ(run({count()}, "count"), 3);
    EXPECT_EQ(run({count()}, "count", "--apples", "5"), 5);
}

TEST(RunVerb, RunsNoOtherVerb) {
    Verb other = count();
    other.name = "other";
    EXPECT_EQ(run({other, count()}, "count", "--apples", "4"), 4);
}

TEST(Verbs, HaveAnExampleInTheirHelp) {
    for (const std::vector<Verb>& verbs : {catalogue_verbs(), shipped_verbs()})
        for (const Verb& verb : verbs) {
            testing::internal::CaptureStdout();
            EXPECT_EQ(run(verbs, verb.name.c_str(), "--help"), 0);
            const std::string help = testing::internal::GetCapturedStdout();
            EXPECT_THAT(help, testing::HasSubstr(verb.about));
            EXPECT_THAT(help, testing::HasSubstr("Example"));
        }
}

TEST(Verbs, OfACatalogueAreShippedToo) {
    std::set<std::string> shipped;
    for (const Verb& verb : shipped_verbs()) EXPECT_TRUE(shipped.insert(verb.name).second) << verb.name;
    for (const Verb& verb : catalogue_verbs()) EXPECT_TRUE(shipped.contains(verb.name)) << verb.name;
}

TEST(Options, NameTheNearestKnownWord) {
    EXPECT_THAT(complaint("verfy"), testing::HasSubstr("did you mean 'verify'"));
    EXPECT_THAT(complaint("verify", "--aplha", "0.1"), testing::HasSubstr("did you mean '--alpha'"));
}

TEST(Options, SayWhatAValueMayBe) {
    EXPECT_THAT(complaint("verify", "--alpha", "2"), testing::HasSubstr("(0, 1)"));
    EXPECT_THAT(complaint("verify", "--threads", "0"), testing::HasSubstr("--threads"));
    EXPECT_THAT(complaint("render", "glass", "--spp", "0"), testing::HasSubstr("--spp"));
    EXPECT_THAT(complaint("verify", "--time-limit", "soon"), testing::HasSubstr("1.5m"));
    EXPECT_THAT(complaint("converge", "torus", "--on", "exp", "--n", "64..16"), testing::HasSubstr("backwards"));
    EXPECT_THAT(complaint("verify", "--seed", "-1"), testing::HasSubstr("from 0 to 2^64 - 1"));
    EXPECT_THAT(complaint("verify", "--shard", "1/2"), testing::HasSubstr("--shard requires --seed"));
    EXPECT_THAT(complaint("verify", "--resume", "--alpha", "0.1"), testing::HasSubstr("--alpha"));
    EXPECT_THAT(complaint("verify", "--resume", "points/*"), testing::HasSubstr("keeps the patterns"));
    EXPECT_THAT(complaint(), testing::HasSubstr("subcommand"));
}

TEST(Options, OfASamplerGoTogether) {
    EXPECT_THAT(complaint("verify", "--delta", "0.1"), testing::HasSubstr("--delta requires --sampler"));
    EXPECT_THAT(complaint("verify", "points/*", "--sampler", "./s", "--density", "uniform"),
                testing::HasSubstr("patterns"));
}

}  // namespace
}  // namespace plumb::cli
