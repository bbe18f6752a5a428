// The same seed gives the same verdicts to the bit, whatever the number of threads.

#include <gtest/gtest.h>

#include "reports/run/json.h"
#include "verification/runner.h"
#include "verification/suites/suites.h"

namespace plumb::cli {
namespace {

std::string verdicts(int threads) {
    const Catalogue catalogue = suites::shipped_catalogue();
    const RunSetting setting{.seed = 20240229, .patterns = {"points/*", "debiasing/*"}, .threads = threads};
    reports::Results results;
    for (Judged& one : judge(catalogue, setting, [](const Judged&, std::size_t, std::size_t) {})) {
        reports::ClaimResult& result = results.claims.emplace_back();
        result.id = one.id();
        result.verdict = std::move(one.verdict);
    }
    return reports::to_json(reports::without_side_records(std::move(results)));
}

TEST(Determinism, OneThreadAndTwoGiveTheSameVerdicts) {
    EXPECT_EQ(verdicts(1), verdicts(2));
}

}  // namespace
}  // namespace plumb::cli
