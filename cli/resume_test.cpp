// The real program, interrupted and resumed, or split into shards and merged, gives what one run gives; verbs that
// cannot go on say so.

#include <gmock/gmock.h>
#include <sqlite3.h>

#include <algorithm>
#include <thread>

#include "cli/test_program.h"
#include "reports/run/json.h"
#include "reports/run/store.h"

namespace plumb::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr, testing::SizeIs;
using clock = std::chrono::steady_clock;

using Words = std::vector<std::string>;

Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

const Words much = {"verify", "points/*", "mis/*", "--seed", "7", "--threads", "1"};
const Words some = {"verify", "mis/*", "--seed", "7", "--threads", "1"};
const Words little = {"verify", "debiasing/*", "--seed", "7"};

/// What a run left in its JSON file, without side records.
std::string json_of(const fs::path& file) {
    return reports::to_json(reports::without_side_records(reports::results_from_json(read_file(file), file.string())));
}

reports::Results stored(const fs::path& file) {
    const reports::Store store(file, reports::Store::Access::read);
    EXPECT_THAT(store.runs(), SizeIs(1));
    return store.load(1);
}

std::string comparable(const fs::path& store) {
    return reports::to_json(reports::without_side_records(stored(store)));
}

void wait_for_a_verdict(const fs::path& store) {
    const auto has_one = [&] {
        if (!fs::exists(store) || fs::file_size(store) == 0) return false;
        const reports::Results results =
            reports::Store(store, reports::Store::Access::read).runs().empty() ? reports::Results() : stored(store);
        return !results.claims.empty();
    };
    for (const auto give_up = clock::now() + std::chrono::minutes(2); !has_one() && clock::now() < give_up;)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

class Interrupted : public testing::TestWithParam<int> {};

TEST_P(Interrupted, EndsAsIfItHadNotBeenInterrupted) {
    const TestFolder folder;
    Program whole(folder.path(), with(much, {"--store", "whole.db", "--json", "whole.json"}));
    const int code = whole.wait();

    Program interrupted(folder.path(), with(much, {"--store", "a.db", "--json", "a.json", "--report", "a.html"}));
    wait_for_a_verdict(folder / "a.db");
    const auto asked = clock::now();
    interrupted.send(GetParam());
    EXPECT_EQ(interrupted.wait(), 128 + GetParam());
    EXPECT_LT(clock::now() - asked, std::chrono::seconds(1));
    EXPECT_THAT(interrupted.errors(), HasSubstr("`plumb verify --resume --store a.db` goes on"));
    EXPECT_FALSE(fs::exists(folder / "a.json") || fs::exists(folder / "a.html")) << "no partial output";
    const std::size_t kept = stored(folder / "a.db").claims.size();
    EXPECT_GT(kept, 0u);
    EXPECT_LT(kept, stored(folder / "whole.db").claims.size());

    Program resumed(folder.path(), {"verify", "--resume", "--store", "a.db", "--json", "a.json"});
    EXPECT_EQ(resumed.wait(), code) << resumed.errors();
    EXPECT_EQ(json_of(folder / "a.json"), json_of(folder / "whole.json"));
    EXPECT_EQ(comparable(folder / "a.db"), comparable(folder / "whole.db"));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, testing::Values(SIGINT, SIGTERM),
                         [](const auto& signal) { return signal.param == SIGINT ? "Interrupt" : "Terminate"; });

TEST(Resume, GoesOnAfterTheDiskWasFull) {
    const TestFolder folder;
    Program full(folder.path(), with(little, {"--store", "a.db", "--report", ""}), {.file_size = 40'000});
    EXPECT_EQ(full.wait(), 2);
    EXPECT_THAT(full.errors(), HasSubstr("a.db: cannot be written"));
    Program resumed(folder.path(), {"verify", "--resume", "--store", "a.db", "--report", ""});
    EXPECT_EQ(resumed.wait(), 0) << resumed.errors();
    Program whole(folder.path(), with(little, {"--store", "whole.db", "--report", ""}));
    EXPECT_EQ(whole.wait(), 0);
    EXPECT_EQ(comparable(folder / "a.db"), comparable(folder / "whole.db"));
}

// A kill in the middle of a write leaves SQLite's journal beside the store; here another writer leaves it.
TEST(Resume, GoesOnAfterAKill) {
    const TestFolder folder;
    Program killed(folder.path(), with(some, {"--store", "a.db", "--report", ""}));
    wait_for_a_verdict(folder / "a.db");
    sqlite3* other = nullptr;
    ASSERT_EQ(sqlite3_open((folder / "a.db").c_str(), &other), SQLITE_OK);
    sqlite3_busy_timeout(other, 5000);
    killed.send(SIGKILL);
    EXPECT_EQ(killed.wait(), -SIGKILL);
    ASSERT_EQ(sqlite3_exec(other,
                           "PRAGMA cache_size = 1; BEGIN IMMEDIATE; UPDATE runs SET seconds = 7; UPDATE claims SET "
                           "json = hex(randomblob(100000))",
                           nullptr, nullptr, nullptr),
              SQLITE_OK)
        << sqlite3_errmsg(other);
    for (const std::string name : {"list", "resume", "merge"})
        for (const std::string suffix : {".db", ".db-journal"})
            write_file(folder / (name + suffix), read_file(folder / ("a" + suffix)));
    sqlite3_close(other);

    Program list(folder.path(), {"report", "--list", "--store", "list.db"});
    EXPECT_EQ(list.wait(), 0) << list.errors();
    Program merge(folder.path(), {"merge", "merge.db"});
    EXPECT_EQ(merge.wait(), 2);
    EXPECT_THAT(merge.errors(), HasSubstr("is unfinished; `plumb verify --resume --store merge.db` goes on"));
    Program whole(folder.path(), with(some, {"--store", "whole.db", "--report", ""}));
    Program resumed(folder.path(), {"verify", "--resume", "--store", "resume.db", "--report", ""});
    EXPECT_EQ(resumed.wait(), whole.wait()) << resumed.errors();
    EXPECT_EQ(comparable(folder / "resume.db"), comparable(folder / "whole.db"));
}

TEST(Parts, HaveAPageOfTheirOwn) {
    const TestFolder folder;
    std::filesystem::create_directories(folder / "out");
    write_file(folder / "out/report.html", "the whole");
    Program part(folder.path(), little);
    EXPECT_EQ(part.wait(), 0) << part.errors();
    EXPECT_EQ(read_file(folder / "out/report.html"), "the whole");
    EXPECT_TRUE(fs::exists(folder / "out/report-part.html"));
}

TEST(Shards, MakeUpTheRunWithoutShards) {
    const TestFolder folder;
    Program whole(folder.path(), with(little, {"--store", "whole.db", "--json", "whole.json"}));
    EXPECT_EQ(whole.wait(), 0);
    Words merge = {"merge", "--store", "out.db", "--json", "out.json", "--junit", "out.xml"};
    for (const std::string index : {"2", "1", "3"}) {
        const std::string store = "shard-" + index + ".db";
        Program shard(folder.path(), with(little, {"--shard", index + "/3", "--store", store, "--report", ""}));
        EXPECT_EQ(shard.wait(), 0) << shard.errors();
        merge.push_back(store);
    }
    for (int time = 0; time < 2; ++time) {
        Program merged(folder.path(), merge);
        EXPECT_EQ(merged.wait(), 0) << merged.errors();
        EXPECT_EQ(json_of(folder / "out.json"), json_of(folder / "whole.json"));
        EXPECT_EQ(comparable(folder / "out.db"), comparable(folder / "whole.db"));
    }
    EXPECT_THAT(read_file(folder / "out.xml"), HasSubstr("<testsuite name=\"debiasing\""));
}

// The long verbs that keep nothing of a part of their work say so when they are stopped.
struct LongWork {
    std::vector<std::string> arguments;
    std::string said, output;
};

class Stopped : public testing::TestWithParam<LongWork> {};

TEST_P(Stopped, SaysWhatIsSaved) {
    const auto& [arguments, said, output] = GetParam();
    for (const int signal : {SIGINT, SIGTERM}) {
        const TestFolder folder;
        Program program(folder.path(), arguments);
        program.wait_until_it_catches(signal);
        program.send(signal);
        EXPECT_EQ(program.wait(), 128 + signal);
        const std::string name = signal == SIGINT ? "SIGINT" : "SIGTERM";
        EXPECT_THAT(program.errors(), HasSubstr("plumb: stopped by " + name + ": " + said));
        EXPECT_EQ(std::ranges::count(program.errors(), '\n'), 1);
        EXPECT_FALSE(std::filesystem::exists(folder / output)) << "no partial output";
    }
}

std::vector<LongWork> long_works() {
    return {
        {{"render", "furnace_box", "--spp", "1000000", "-o", "a.exr"}, "nothing is saved; a.exr is as it was", "a.exr"},
        {{"reference", "furnace_box", "--error", "0.001%"}, "nothing is saved; out/references", "out/references"},
        {{"converge", "independent", "--on", "exp", "--replicates", "10000000", "--json", "a.json"},
         "nothing is saved",
         "a.json"},
        {{"integrate", "sin(x*y)", "--n", "4000000000", "--json", "a.json"}, "nothing is saved", "a.json"},
        {{"study", "boundary", "--replicates", "10000000"},
         "nothing is saved; out/study-boundary is as it was",
         "out/study-boundary"}};
}

INSTANTIATE_TEST_SUITE_P(Verbs, Stopped, testing::ValuesIn(long_works()),
                         [](const auto& work) { return work.param.arguments.front(); });

}  // namespace
}  // namespace plumb::cli
