#include "checks/sampler/sampler.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb::checks {
namespace {

using testing::HasSubstr;

// awk's srand and rand: a sampler in another process that every system has.
std::string awk(const std::string& sample) {
    return "awk -v s={seed} -v n={n} 'BEGIN { srand(s); for (i = 0; i < n; i++) { u = rand(); v = rand(); print " +
           sample + " } }'";
}

Verdict judged(const std::string& command, const std::string& density) {
    const Catalogue catalogue =
        sampler_catalogue({.command = command, .density = density, .delta = ErrorTarget{0.1, false}}, 7);
    return catalogue.claims().at(0).trial.judge(Run(7, catalogue.claims().at(0).id, 1e-6));
}

std::string complaint(const SamplerTrial& trial) {
    try {
        (void)sampler_catalogue(trial, 7);
    } catch (const Error& error) {
        return error.what();
    }
    return "no complaint";
}

std::string complaint(const std::string& command) {
    return complaint({.command = command,
                      .density = "uniform",
                      .delta = ErrorTarget{0.1, false},
                      .timeout = std::chrono::seconds(10)});
}

TEST(Sampler, HoldsForItsDensity) {
    EXPECT_EQ(judged(awk("u"), "uniform").outcome, Outcome::holds);
    EXPECT_EQ(judged(awk("sqrt(u)"), "linear:0,1").outcome, Outcome::holds);
    EXPECT_EQ(judged(awk("u \",\" v"), "uniform-2d").outcome, Outcome::holds);
}

TEST(Sampler, IsRefutedInItsOwnTerms) {
    const Verdict verdict = judged(awk("u * u"), "uniform");
    EXPECT_EQ(verdict.outcome, Outcome::refuted);
    EXPECT_THAT(verdict.reason, HasSubstr("[0, 0.015625), of probability 0.01562: found 0.12"));
    EXPECT_EQ(judged(awk("u \",\" u"), "uniform-2d").outcome, Outcome::refuted);
}

TEST(Sampler, IsRefutedByOneSampleOutsideTheSupport) {
    const Verdict verdict = judged(awk("(i == 41 ? 1.25 : u)"), "uniform");
    EXPECT_EQ(verdict.outcome, Outcome::refuted);
    EXPECT_THAT(verdict.reason, HasSubstr("1 of "));
    EXPECT_THAT(verdict.reason, HasSubstr("first line 42: '1.25'"));
    EXPECT_EQ(judged(awk("(i == 41 ? \"nan\" : u)"), "uniform").outcome, Outcome::refuted);
}

TEST(Sampler, IsRefutedWhereCellsSeeNothing) {
    // 2 % of the samples go near 0; and all samples of a cell go to its middle.
    EXPECT_THAT(judged(awk("(u < 0.02 ? u * 1e-3 : u)"), "uniform").reason,
                HasSubstr("[0, 0.000244141), of probability 0.0002441: found 0.0"));
    EXPECT_EQ(judged(awk("(int(u * 64) + 0.5) / 64"), "uniform").outcome, Outcome::refuted);
    EXPECT_THAT(judged(awk("u"), "uniform").reason, HasSubstr("looked in 64 cells, in halves, quarters"));
}

TEST(Sampler, IsNoMoreEvenThanChance) {  // the golden ratio's sequence
    EXPECT_THAT(
        judged("awk -v n={n} 'BEGIN { for (i = 0; i < n; i++) { x = i * 0.6180339887498949; print x - int(x) } }'",
               "uniform")
            .reason,
        HasSubstr("more even than chance"));
}

TEST(Sampler, MayPrintItsDensityBesides) {
    EXPECT_EQ(judged(awk("sqrt(u) \",\" 2 * sqrt(u)"), "linear:0,1").outcome, Outcome::holds);
    EXPECT_THAT(judged(awk("sqrt(u) \",\" sqrt(u)"), "linear:0,1").reason,
                HasSubstr("printed densities are wrong, first line 1"));
}

std::vector<Verdict> all_judged(const SamplerTrial& trial) {
    std::vector<Verdict> verdicts;
    const Catalogue catalogue = sampler_catalogue(trial, 7);
    for (const Claim& claim : catalogue.claims()) verdicts.push_back(claim.trial.judge(Run(7, claim.id, 1e-6)));
    return verdicts;
}

// The law of max(u, v), of density 2x, as the sampler says it; away from 0, so that 1/pdf is bounded.
std::vector<Verdict> own(const std::string& sample) {
    return all_judged({.command = awk(sample), .density = "own", .samples = 1 << 17, .domain = {0, 1}});
}

TEST(Sampler, IsJudgedByTheDensityThatItPrints) {
    for (const Verdict& verdict : own("sqrt(0.25 + 2 * u) - 0.5 \",\" sqrt(0.25 + 2 * u)"))  // (1 + 2x) / 2
        EXPECT_EQ(verdict.outcome, Outcome::holds) << verdict.reason;
    for (const Verdict& verdict : own("u \",\" 1")) EXPECT_EQ(verdict.outcome, Outcome::holds) << verdict.reason;
    const std::vector<Verdict> twice = own("u \",\" 2");
    EXPECT_EQ(twice[0].outcome, Outcome::refuted) << "integrates to 2";
    const std::vector<Verdict> wrong = own("u \",\" u + 0.5");
    EXPECT_EQ(wrong[1].outcome, Outcome::refuted) << "is uniform";
    EXPECT_THAT(own("u \",\" (i == 41 ? 0 : 1)")[0].reason, HasSubstr("line 42"));
}

TEST(Sampler, OfValuesIsJudgedByTheirMean) {
    const auto judge = [](double mean, double delta) {
        return all_judged({.command = awk("u * u"), .mean = mean, .delta = ErrorTarget{delta, false}}).at(0);
    };
    EXPECT_EQ(judge(1.0 / 3, 0.01).outcome, Outcome::holds) << judge(1.0 / 3, 0.01).reason;
    EXPECT_EQ(judge(0.35, 0.01).outcome, Outcome::refuted);
    EXPECT_THAT(complaint(SamplerTrial{.command = awk("u"), .mean = 0.5}), HasSubstr("--mean needs --delta"));
}

TEST(Sampler, GetsTheSameSeedAgain) {
    const auto fields = [] { return judged(awk("u"), "uniform").evidence; };
    EXPECT_EQ(fields(), fields());
}

TEST(Sampler, ThatDoesNotKeepToTheProtocolIsAnError) {
    EXPECT_EQ(complaint("printf '0.5\\n1,2,3\\n'"), "line 2 of the sampler is '1,2,3'; accepted: a number, x");
    EXPECT_EQ(complaint("printf '0.5\\n\\n'"), "line 2 of the sampler is ''; accepted: a number, x");
    EXPECT_EQ(complaint("echo '0.5 1 0'"), "line 1 of the sampler is '0.5 1 0'; accepted: a number, x");
    EXPECT_THAT(complaint("printf '0.5\\n0.6'"), HasSubstr("ended after 2 of "));
    EXPECT_THAT(complaint("true"), HasSubstr("ended after 0 of "));
    EXPECT_THAT(complaint("echo 0.5; exit 9"), HasSubstr("exit code 9"));
    EXPECT_THAT(complaint({.command = "sleep 20", .density = "uniform", .timeout = std::chrono::milliseconds(100)}),
                HasSubstr("was not done after 0.1 s"));
    EXPECT_THAT(complaint({.command = "true", .density = "uniform", .delta = ErrorTarget{1e-5, false}}),
                HasSubstr("accepted: at most"));
}

TEST(Sampler, MayPrintMoreThanItWasAskedFor) {
    EXPECT_EQ(judged("yes 0.5", "uniform").outcome, Outcome::refuted);
}

}  // namespace
}  // namespace plumb::checks
