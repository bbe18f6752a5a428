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
    const Catalogue catalogue = sampler_catalogue({.command = command, .density = density, .delta = 0.1}, 7);
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
    return complaint({.command = command, .density = "uniform", .delta = 0.1, .timeout = std::chrono::seconds(10)});
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

TEST(Sampler, GetsTheSameSeedAgain) {
    const auto fields = [] { return judged(awk("u"), "uniform").evidence; };
    EXPECT_EQ(fields(), fields());
}

TEST(Sampler, ThatDoesNotKeepToTheProtocolIsAnError) {
    EXPECT_EQ(complaint("printf '0.5\\n1,2\\n'"), "line 2 of the sampler is '1,2'; accepted: a number, x");
    EXPECT_EQ(complaint("printf '0.5\\n\\n'"), "line 2 of the sampler is ''; accepted: a number, x");
    EXPECT_EQ(complaint("echo '0.5 0.5'"), "line 1 of the sampler is '0.5 0.5'; accepted: a number, x");
    EXPECT_THAT(complaint("printf '0.5\\n0.6'"), HasSubstr("ended after 2 of "));
    EXPECT_THAT(complaint("true"), HasSubstr("ended after 0 of "));
    EXPECT_THAT(complaint("echo 0.5; exit 9"), HasSubstr("exit code 9"));
    EXPECT_THAT(complaint({.command = "sleep 20", .density = "uniform", .timeout = std::chrono::milliseconds(100)}),
                HasSubstr("was not done after 0.1 s"));
    EXPECT_THAT(complaint({.command = "true", .density = "uniform", .delta = 1e-5}), HasSubstr("accepted: at most"));
}

TEST(Sampler, MayPrintMoreThanItWasAskedFor) {
    EXPECT_EQ(judged("yes 0.5", "uniform").outcome, Outcome::refuted);
}

}  // namespace
}  // namespace plumb::checks
