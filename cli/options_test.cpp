#include "cli/options.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb::cli {
namespace {

template <class... Words>
Options parse(Words... words) {
    const std::array<const char*, sizeof...(words) + 1> argv = {"plumb", words...};
    return parse_options(static_cast<int>(argv.size()), argv.data());
}

// Parses what must fail, and gives the one line on standard error.
template <class... Words>
std::string complaint(Words... words) {
    testing::internal::CaptureStderr();
    const Options options = parse(words...);
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_TRUE(std::holds_alternative<Answered>(options) && std::get<Answered>(options).exit_code == 2);
    EXPECT_EQ(std::ranges::count(text, '\n'), 1) << text;
    return text;
}

TEST(Options, ReadAVerifyLine) {
    const auto verify = std::get<VerifyOptions>(
        parse("verify", "points/*", "--full", "--alpha", "1e-3", "--time-limit", "2m", "--seed", "7"));
    EXPECT_EQ(verify.patterns, std::vector<std::string>{"points/*"});
    EXPECT_TRUE(verify.full);
    EXPECT_EQ(verify.alpha, 1e-3);
    EXPECT_EQ(verify.time_limit->count(), 120);
    EXPECT_EQ(verify.seed, 7u);
}

TEST(Options, ReadAConvergeLine) {
    const auto converge =
        std::get<ConvergeOptions>(parse("converge", "torus", "independent", "--on", "exp", "--n", "16..64"));
    EXPECT_EQ(converge.estimators, (std::vector<std::string>{"torus", "independent"}));
    EXPECT_EQ(converge.integrands, std::vector<std::string>{"exp"});
    EXPECT_EQ(converge.n, (std::vector<std::uint64_t>{16, 32, 64}));
}

TEST(Options, ReadAStudyLine) {
    const auto study = std::get<StudyOptions>(parse("study", "mine.toml", "--replicates", "10", "--out", "here"));
    EXPECT_EQ(study.study, "mine.toml");
    EXPECT_EQ(study.replicates, 10U);
    EXPECT_EQ(study.out, "here");
    EXPECT_TRUE(std::get<StudyOptions>(parse("study", "--list")).list);
}

TEST(Options, ReadAnIntegrateLine) {
    const auto integrate = std::get<IntegrateOptions>(parse("integrate", "x*y", "--method", "torus", "--error", "1%",
                                                            "--domain", "-1,1,0,2", "--lookup", "bilinear"));
    EXPECT_EQ(integrate.what, std::vector<std::string>{"x*y"});
    EXPECT_EQ(integrate.method, "torus");
    EXPECT_TRUE(integrate.error->relative);
    EXPECT_EQ(integrate.domain, (std::vector<double>{-1, 1, 0, 2}));
    EXPECT_FALSE(integrate.n);
    const auto weights = std::get<WeightsOptions>(parse("weights", "p.csv", "--periodic", "-o", "w.csv"));
    EXPECT_TRUE(weights.periodic);
    EXPECT_EQ(weights.out, "w.csv");
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

TEST(Options, PutASamplerOnTrial) {
    const auto verify = std::get<VerifyOptions>(
        parse("verify", "--sampler", "./s {seed} {n}", "--density", "linear:0,1", "--sampler-timeout", "5s"));
    EXPECT_EQ(verify.sampler.command, "./s {seed} {n}");
    EXPECT_EQ(verify.sampler.density, "linear:0,1");
    EXPECT_EQ(verify.sampler.timeout.count(), 5);
    EXPECT_THAT(complaint("verify", "--sampler", "./s"), testing::HasSubstr("--density"));
    EXPECT_THAT(complaint("verify", "points/*", "--sampler", "./s", "--density", "uniform"),
                testing::HasSubstr("patterns"));
}

TEST(ParseShard, AcceptsAPartOfAWhole) {
    EXPECT_EQ(parse_shard("2/3").index, 2);
    EXPECT_EQ(parse_shard("2/3").count, 3);
    for (const char* wrong : {"3/2", "0/2", "1/0", "1", "/2", "1/", "1/2/3", "-1/2", "1/10001", ""})
        EXPECT_THROW(parse_shard(wrong), Error) << wrong;
}

TEST(ParseDuration, KnowsItsUnits) {
    EXPECT_EQ(parse_duration("90").count(), 90);
    EXPECT_EQ(parse_duration("1.5m").count(), 90);
    EXPECT_EQ(parse_duration("1h").count(), 3600);
    EXPECT_THROW(parse_duration("-1s"), Error);
    EXPECT_THROW(parse_duration("1d"), Error);
    EXPECT_THROW(parse_duration("nan"), Error);
}

TEST(ParseErrorTarget, IsAbsoluteOrRelative) {
    EXPECT_EQ(parse_error_target("1e-3").error, 1e-3);
    EXPECT_FALSE(parse_error_target("1e-3").relative);
    EXPECT_EQ(parse_error_target("2%").error, 0.02);
    EXPECT_TRUE(parse_error_target("2%").relative);
    for (const char* bad : {"", "%", "0", "-1", "nan", "inf", "1e-3x", "1%%", "1 %"})
        EXPECT_THROW(parse_error_target(bad), Error) << bad;
}

TEST(ParseDomain, HasBothEndsOfEachAxis) {
    EXPECT_EQ(parse_strategy("0,2"), (std::vector<int>{0, 2}));
    EXPECT_EQ(parse_strategy("3,1"), (std::vector<int>{3, 1}));
    for (const char* bad : {"", "2", "-1,3", "2,0", "0,1", "1,1,1", "1,", "a,b", "1, 2"})
        EXPECT_THROW(parse_strategy(bad), Error) << bad;
    EXPECT_EQ(parse_domain("0,1"), (std::vector<double>{0, 1}));
    EXPECT_EQ(parse_domain("-1,1.5,1e-3,2"), (std::vector<double>{-1, 1.5, 1e-3, 2}));
    for (const char* bad : {"", "0", "0,1,", ",0,1", "1,0", "0,0", "0,1,2", "0,1,0,nan", "0,inf", "0;1", "0,1,0,1,0,1",
                            "-1.7e308,1.7e308"})
        EXPECT_THROW(parse_domain(bad), Error) << bad;
}

}  // namespace
}  // namespace plumb::cli
