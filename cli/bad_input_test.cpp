// Bad input ends the real program with 2 and one line that names the thing, and leaves no file behind.

#include <gmock/gmock.h>
#include <sqlite3.h>

#include <set>

#include "cli/test_program.h"
#include "reports/run/sample_results.h"
#include "reports/run/store.h"

namespace plumb::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Case {
    std::vector<std::string> arguments;
    std::string said;
    Program::Limits limits = {};
};

void execute(const fs::path& file, const char* sql, sqlite3** keep = nullptr) {
    sqlite3* database = nullptr;
    sqlite3_open(file.c_str(), &database);
    ASSERT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(database);
    if (keep)
        *keep = database;
    else
        sqlite3_close(database);
}

void store_a_run(const fs::path& file, int shards = 1) {
    reports::Results results = reports::sample_results();
    results.run.shards = shards;
    reports::Store(file, reports::Store::Access::append).append(results);
}

std::set<std::string> files_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) names.insert(entry.path());
    return names;
}

class BadInput : public testing::Test {
protected:
    void expect(const std::vector<Case>& cases) const {
        const std::set<std::string> before = files_in(folder.path());
        for (const Case& one : cases) {
            SCOPED_TRACE(testing::PrintToString(one.arguments));
            Program program(folder.path(), one.arguments, one.limits);
            EXPECT_EQ(program.wait(), 2);
            const std::string said = program.errors();
            EXPECT_THAT(said, AllOf(testing::StartsWith("plumb: "), HasSubstr(one.said)));
            EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
            EXPECT_EQ(files_in(folder.path()), before);
        }
    }
    const TestFolder folder;
};

TEST_F(BadInput, OfWords) {
    expect({{{}, "subcommand is required"},
            {{"verfy"}, "unknown verb 'verfy'; did you mean 'verify'?"},
            {{"verify", "--aplha", "0.1"}, "unknown option '--aplha'; did you mean '--alpha'?"},
            {{"verify", "pionts/*"}, "no claim matches 'pionts/*'"},
            {{"list", "claim"}, "unknown list 'claim'; did you mean 'claims'?"},
            {{"converge", "nothing", "--on", "exp"}, "unknown 1D estimator 'nothing'"}});
}

TEST_F(BadInput, OfValues) {
    expect({{{"verify", "--threads", "0"}, "--threads: '0' is not a whole number from 1 to 4096"},
            {{"verify", "--alpha", "2"}, "--alpha: '2' is not a number in (0, 1)"},
            {{"verify", "--alpha", "nan"}, "--alpha: 'nan' is not a number in (0, 1)"},
            {{"verify", "--seed", "1.5"}, "--seed: '1.5' is not a whole number from 0 to 2^64 - 1"},
            {{"verify", "--time-limit", "soon"}, "--time-limit: 'soon' is not a duration"},
            {{"verify", "--seed", "1", "--shard", "3/2"}, "--shard: '3/2' is not a shard; accepted: i/n"},
            {{"verify", "--shard", "1/2"}, "--shard requires --seed: all shards of a run must have the same seed"},
            {{"verify", "--resume", "--sampler", "yes"}, "samples are asked for anew"},
            {{"integrate", "x", "--n", "1.5"},
             "--n: '1.5' is not a whole number from 1 to 4294967296; accepted: 1000, 1e3"},
            {{"verify", "--resume", "--seed", "1"}, "a resumed run keeps"}});
}

TEST_F(BadInput, OfOutputs) {
    write_file(folder / "file", "");
    fs::create_directories(folder / "taken");
    expect({{{"verify", "--json", "file/x.json"}, "file/x.json: cannot be written: file is not a folder"},
            {{"verify", "--junit", "taken"}, "taken: cannot be written: it is a folder"},
            {{"verify", "--report", "/proc/report.html"}, "/proc/report.html: cannot be written"},
            {{"verify", "--json", "out.json", "--junit", "./out.json"}, "named by --json and --junit"},
            {{"verify", "--json", "results.db", "--store", "results.db"}, "named by --store and --json"},
            {{"converge", "independent", "--on", "exp", "--report", "taken"}, "taken: cannot be written"},
            {{"list", "claims"}, "standard output: cannot", {.standard_output = "/dev/full"}}});
}

TEST_F(BadInput, OfStores) {
    write_file(folder / "file", "");
    write_file(folder / "text.db", std::string(5000, 'x'));
    execute(folder / "mail.db", "CREATE TABLE mail (subject TEXT)");
    store_a_run(folder / "finished.db");
    store_a_run(folder / "newer.db");
    execute(folder / "newer.db", "PRAGMA user_version = 99");
    expect({{{"verify", "--store", "text.db"}, "text.db: not a results store, or damaged"},
            {{"verify", "--store", "mail.db"}, "mail.db: a SQLite database, but not a results store"},
            {{"verify", "--store", "newer.db"}, "newer.db: written by a newer plumb (schema 99; this one knows 2)"},
            {{"verify", "--store", "/proc/results.db"}, "/proc/results.db: cannot be opened or made"},
            {{"verify", "--store", "file/results.db"}, "file/results.db: its folder cannot be made"},
            {{"verify", "--store", "results.db"}, "results.db: cannot be written", {.file_size = 16384}},
            {{"verify", "--resume", "--store", "none.db"}, "none.db: there is no such results store"},
            {{"verify", "--resume", "--store", "finished.db"}, "finished.db: no run is unfinished"},
            {{"report", "--store", "finished.db", "--run", "7"}, "there is no run 7; the last one is 1"}});
}

TEST_F(BadInput, OfMerges) {
    store_a_run(folder / "one.db", 2);
    expect({{{"merge"}, "stores is required"},
            {{"merge", "none.db"}, "none.db: there is no such results store"},
            {{"merge", "one.db"}, "the run with seed 17592186044416123457 lacks shard 2/2"}});
}

TEST_F(BadInput, OfSamplers) {
    write_file(folder / "pdf.csv", "from,to,density\n0,1,0.5\n1,2,much\n");
    const auto verify = [](std::string sampler, std::string density) {
        return std::vector<std::string>{"verify", "--sampler", std::move(sampler), "--density", std::move(density)};
    };
    std::vector<std::string> hanging = verify("sleep 20", "uniform");
    hanging.insert(hanging.end(), {"--sampler-timeout", "0.1s"});
    expect(
        {{verify("./none {seed} {n}", "uniform"), "ended with exit code 127: sh: 1: ./none: not found"},
         {verify("echo 0.5; echo half", "uniform"), "line 2 of the sampler is 'half'; accepted: a number, x"},
         {verify("echo 0.5", "uniform"), "'echo 0.5' ended after 1 of "},
         {verify("kill -SEGV $$", "uniform"), "was ended by signal 11"},
         {verify("yes 0.5", "uniforn"), "the density 'uniforn' is no file, has no known name (known: uniform, linear"},
         {verify("yes 0.5", "pdf.csv"), "pdf.csv:3: column 3 (density): 'much' found"},
         {hanging, "'sleep 20' was not done after 0.1 s"},
         {{"verify", "--sampler", "yes"}, "--sampler: judged by what? Give --density, or --mean"},
         {{"verify", "--density", "uniform"}, "--density requires --sampler"}});
}

TEST_F(BadInput, OfALockedStore) {
    store_a_run(folder / "results.db");
    sqlite3* other = nullptr;
    execute(folder / "results.db", "BEGIN IMMEDIATE", &other);
    write_file(folder / "results.db-journal", "");  // SQLite's own, there as long as the other writes
    expect({{{"verify", "--store", "results.db"}, "results.db: locked by another process"}});
    sqlite3_close(other);
}

TEST_F(BadInput, OfAReadOnlyFolder) {
    if (geteuid() == 0) GTEST_SKIP() << "nothing is read-only to root";
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    expect({{{"verify", "--report", "", "--store", "results.db"}, "results.db: cannot be opened or made"},
            {{"verify", "--report", "report.html", "--store", "results.db"}, "report.html: cannot be written"}});
    fs::permissions(folder.path(), fs::perms::owner_all);
}

}  // namespace
}  // namespace plumb::cli
