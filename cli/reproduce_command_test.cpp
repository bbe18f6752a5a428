// Statements of papers against measurements, as the program makes the page of them: whole, in shards, interrupted.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "cli/command_test.h"
#include "cli/test_program.h"
#include "reports/run/store.h"

namespace plumb::cli {
namespace {

using testing::AllOf, testing::HasSubstr, testing::SizeIs;
using Json = nlohmann::json;

class ReproduceCommand : public CommandTest {
protected:
    /// What was measured, without when and how fast.
    [[nodiscard]] Json headlines(const std::string& page) const {
        return Json::parse(read(page + "/headlines.json"))["headlines"];
    }
    [[nodiscard]] reports::Results newest(const std::string& store) const {
        const reports::Store opened(folder / store, reports::Store::Access::read);
        const auto runs = opened.runs();
        return runs.empty() ? reports::Results() : opened.load(runs.back().id);
    }
};

TEST_F(ReproduceCommand, LaysStatementsAgainstMeasurements) {
    const Said said = plumb("reproduce rates/combinations --seed 7 --threads 2");
    EXPECT_EQ(said.exit_code, 0) << said.error;
    EXPECT_THAT(said.out, AllOf(HasSubstr("met"), HasSubstr("run 1 in out/results.db, seed 7"),
                                HasSubstr("page: out/reproduce/index.html")));
    const Json document = Json::parse(read("out/reproduce/headlines.json"));
    EXPECT_EQ(document["run"]["seed"], 7);
    EXPECT_EQ(document["run"]["size"], "quick");
    const Json& list = document["headlines"];
    ASSERT_THAT(list, SizeIs(3));
    const Json& bound = list[1];
    EXPECT_EQ(bound["source"], "[Veach 1997]");
    EXPECT_EQ(bound["place"], "theorem 9.2");
    EXPECT_EQ(bound["quoted"], false);
    EXPECT_EQ(bound["outcome"], "met");
    EXPECT_EQ(bound["figure"], "rates-combinations");
    EXPECT_LT(bound["measured"]["high"], bound["stated"]["high"]);
    EXPECT_THAT(read("out/reproduce/headlines.csv"), HasSubstr("[Veach 1997],theorem 9.2,"));
    EXPECT_THAT(read("out/reproduce/index.html"),
                AllOf(HasSubstr("<title>Plumb: What papers promise"), HasSubstr("\"id\":\"rates-combinations\""),
                      HasSubstr("*Robust Monte Carlo Methods"), HasSubstr("\"several\":true")));
    EXPECT_THAT(read("out/reproduce/rates-combinations-exp.svg"), HasSubstr("mis-balance"));
}

TEST_F(ReproduceCommand, TakesShardsThatMergeJoins) {
    const std::string call = "reproduce rates/combinations rates/smooth-1d densities --seed 7 ";
    EXPECT_EQ(plumb(call + "--out whole").exit_code, 0);
    const Said part = plumb(call + "--shard 1/2 --store 1.db --out part");
    EXPECT_THAT(part.out, HasSubstr("of other shards: rates/smooth-1d"));
    EXPECT_THAT(complaint("merge 1.db --store joined.db"), HasSubstr("the run with seed 7 lacks shard 2/2"));
    EXPECT_EQ(plumb(call + "--shard 2/2 --store 2.db --out ''").exit_code, 0);
    for (int time = 0; time < 2; ++time) {
        const Said joined = plumb("merge 2.db 1.db --store joined.db --out joined");
        EXPECT_EQ(joined.exit_code, 0) << joined.error;
        EXPECT_THAT(joined.out, HasSubstr("run 1 in joined.db, seed 7"));
        EXPECT_EQ(headlines("joined"), headlines("whole"));
    }
    EXPECT_EQ(plumb("reproduce densities --seed 8 --shard 2/2 --store other.db --out ''").exit_code, 0);
    EXPECT_THAT(complaint("merge 1.db other.db --store joined.db"), HasSubstr("are of different runs: seed 7 and 8"));
}

TEST_F(ReproduceCommand, GoesOnWhereItWasInterrupted) {
    const std::vector<std::string> much = {"reproduce", "rates", "boundary/strata", "--seed", "7"};
    std::vector<std::string> whole = much, interrupted = much;
    whole.insert(whole.end(), {"--store", "whole.db", "--out", "whole"});
    interrupted.insert(interrupted.end(), {"--store", "a.db", "--out", "a"});
    EXPECT_EQ(Program(folder.path(), whole).wait(), 0);

    Program stopped(folder.path(), interrupted);
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    const auto has_one = [&] {
        const std::filesystem::path store = folder / "a.db";
        return std::filesystem::exists(store) && std::filesystem::file_size(store) > 0 &&
               !newest("a.db").series.empty();
    };
    while (!has_one() && std::chrono::steady_clock::now() < give_up)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    stopped.send(SIGINT);
    EXPECT_EQ(stopped.wait(), 130);
    EXPECT_THAT(stopped.errors(),
                HasSubstr("figures are kept in a.db, run 1; `plumb reproduce --resume --store a.db`"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a")) << "no partial page";
    EXPECT_LT(newest("a.db").series.size(), newest("whole.db").series.size());

    const Said resumed = plumb("reproduce --resume --store a.db --out a");
    EXPECT_EQ(resumed.exit_code, 0) << resumed.error;
    EXPECT_EQ(headlines("a"), headlines("whole"));
    EXPECT_THAT(complaint("reproduce --resume --store a.db --out a"), HasSubstr("no run is unfinished"));
}

TEST_F(ReproduceCommand, SaysWhatIsWrongWithItsOptions) {
    EXPECT_THAT(complaint("reproduce nothing"), HasSubstr("no study or figure with headlines matches 'nothing'"));
    EXPECT_THAT(complaint("reproduce --shard 1/2"), HasSubstr("all shards of a run must have the same seed"));
    EXPECT_THAT(complaint("reproduce --resume --seed 7"), HasSubstr("a resumed run keeps the patterns, seed, size"));
    EXPECT_THAT(complaint("reproduce --resume --store none.db"), HasSubstr("none.db: there is no such results store"));
}

}  // namespace
}  // namespace plumb::cli
