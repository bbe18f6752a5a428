#include "reports/run/store.h"

#include <gmock/gmock.h>
#include <sqlite3.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdio>

#include "core/error.h"
#include "core/file.h"
#include "core/test_folder.h"
#include "reports/run/json.h"
#include "reports/run/sample_results.h"
#include "reports/run/sqlite.h"

namespace plumb::reports {
namespace {

using testing::AllOf, testing::HasSubstr, testing::SizeIs;

/// Another program with the file open.
class Other {
public:
    explicit Other(const std::filesystem::path& file) { sqlite3_open(file.c_str(), &database_); }
    ~Other() { sqlite3_close(database_); }
    Other(const Other&) = delete;
    Other& operator=(const Other&) = delete;
    void run(const char* sql) const {
        ASSERT_EQ(sqlite3_exec(database_, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(database_);
    }

private:
    sqlite3* database_ = nullptr;
};

Store fresh(const std::filesystem::path& file) {
    return Store(file, Store::Access::append);
}

std::string open_error(const std::filesystem::path& file, Store::Access access = Store::Access::append) {
    return error_of([&] { Store(file, access); });
}

TEST(Store, GivesBackARunAsItWas) {
    const TestFolder folder;
    const auto file = folder / "out/results.db";
    EXPECT_EQ(fresh(file).append(sample_results()), 1);
    EXPECT_EQ(fresh(file).append(earlier_sample_results()), 2);
    const Store store(file, Store::Access::read);
    EXPECT_EQ(to_json(store.load(1)), to_json(sample_results()));
    EXPECT_EQ(to_json(store.load(2)), to_json(earlier_sample_results()));
}

TEST(Store, ListsItsRuns) {
    const TestFolder folder;
    Store store = fresh(folder / "results.db");
    EXPECT_THAT(store.runs(), SizeIs(0));
    store.append(sample_results());
    store.append({});
    const std::vector<StoredRun> runs = store.runs();
    ASSERT_THAT(runs, SizeIs(2));
    EXPECT_EQ(runs[0].id, 1);
    EXPECT_EQ(runs[0].run.seed, sample_results().run.seed);
    const Tally found = runs[0].tally, expected = tally(sample_results());
    EXPECT_EQ(found.holds, expected.holds);
    EXPECT_EQ(found.refuted, expected.refuted);
    EXPECT_EQ(found.undecided, expected.undecided);
    EXPECT_EQ(found.killed, expected.killed);
    EXPECT_EQ(found.mutants, expected.mutants);
    EXPECT_EQ(runs[1].tally.holds, 0U);
}

TEST(Store, SaysWhichRunsThereAre) {
    const TestFolder folder;
    Store store = fresh(folder / "results.db");
    store.append(sample_results());
    EXPECT_THAT(error_of([&] { (void)store.load(7); }), HasSubstr("results.db: there is no run 7; the last one is 1"));
}

TEST(Store, StoresARunWholeOrNotAtAll) {
    const TestFolder folder;
    Store store = fresh(folder / "results.db");
    Other(folder / "results.db")
        .run("CREATE TRIGGER full BEFORE INSERT ON errata BEGIN SELECT RAISE(ABORT, 'no errata today'); END");
    EXPECT_THAT(error_of([&] { store.append(sample_results()); }), HasSubstr("results.db: no errata today"));
    EXPECT_THAT(store.runs(), SizeIs(0));
}

TEST(Store, KeepsVerdictsAsTheyCome) {
    const TestFolder folder;
    const Results whole = sample_results();
    Store store = fresh(folder / "results.db");
    const std::int64_t run = store.begin(whole.run, whole.errata);
    store.add(run, {whole.claims[3]}, {whole.mutants[1]}, 1.5);
    const std::vector<StoredRun> runs = fresh(folder / "results.db").runs();
    EXPECT_FALSE(runs.at(0).run.finished);
    EXPECT_EQ(runs.at(0).run.seconds, 1.5);
    EXPECT_EQ(store.load(run).claims.at(0).id, whole.claims[3].id);

    store.add(run, whole.claims, whole.mutants, whole.run.seconds);  // also what is there already
    store.finish(run);
    Results expected = whole;
    expected.series.clear();
    EXPECT_EQ(to_json(store.load(run)), to_json(expected));
}

TEST(Store, LeavesNoFileWhenItCannotBeMade) {
    const TestFolder folder;
    const rlimit none{0, RLIM_INFINITY};
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &none);
    const std::string error = open_error(folder / "results.db");
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_THAT(error, HasSubstr("results.db: cannot be written"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Store, SaysThatItIsLocked) {
    const TestFolder folder;
    Store store(folder / "results.db", Store::Access::append, std::chrono::milliseconds(10));
    const Other other(folder / "results.db");
    other.run("BEGIN EXCLUSIVE");
    EXPECT_THAT(error_of([&] { store.append(sample_results()); }), HasSubstr("results.db: locked by another process"));
    EXPECT_THROW((void)store.runs(), Error);
    other.run("COMMIT");
    EXPECT_EQ(store.append(sample_results()), 1);
}

// What kill -9 leaves of `store` in the middle of a write: pages of the transaction in the file, and the journal.
void copy_cut_off(const std::filesystem::path& store, const std::filesystem::path& to) {
    const Other writer(store);
    writer.run("PRAGMA cache_size = 1; BEGIN IMMEDIATE; UPDATE claims SET json = hex(randomblob(100000));");
    for (const char* suffix : {"", "-journal"}) write_file(to.string() + suffix, read_file(store.string() + suffix));
}

TEST(Store, UndoesWhatAKilledWriterLeft) {
    const TestFolder folder;
    fresh(folder / "results.db").append(sample_results());
    for (const Store::Access access : {Store::Access::read, Store::Access::append}) {
        const auto file = folder / "killed.db";
        copy_cut_off(folder / "results.db", file);
        EXPECT_NE(read_file(file), read_file(folder / "results.db")) << "half written";
        EXPECT_EQ(to_json(Store(file, access).load(1)), to_json(sample_results()));
        EXPECT_FALSE(std::filesystem::exists(file.string() + "-journal"));
    }
}

TEST(Store, SaysHowToUndoWhatItMayNotWrite) {
    const TestFolder folder;
    fresh(folder / "results.db").append(sample_results());
    copy_cut_off(folder / "results.db", folder / "killed.db");
    const sqlite::Database database(folder / "killed.db", SQLITE_OPEN_READONLY, 0);
    EXPECT_THAT(error_of([&] { (void)database.pragma("application_id"); }),
                AllOf(HasSubstr("killed.db: its last write was cut off"), HasSubstr("killed.db-journal")));
}

TEST(Store, SaysThatNothingWasStoredYet) {
    const TestFolder folder;
    write_file(folder / "results.db", "");  // killed before the first transaction
    EXPECT_THAT(open_error(folder / "results.db", Store::Access::read), HasSubstr("results.db: no run was stored"));
    EXPECT_EQ(fresh(folder / "results.db").append(sample_results()), 1);
}

TEST(Store, RefusesWhatIsNoStore) {
    const TestFolder folder;
    write_file(folder / "text.db", std::string(5000, 'x'));
    EXPECT_THAT(open_error(folder / "text.db"), HasSubstr("text.db: not a results store, or damaged"));
    EXPECT_EQ(read_file(folder / "text.db"), std::string(5000, 'x')) << "left as it was";

    Other(folder / "mail.db").run("CREATE TABLE mail (subject TEXT)");
    EXPECT_THAT(open_error(folder / "mail.db"), HasSubstr("mail.db: a SQLite database, but not a results store"));
    EXPECT_THAT(open_error(folder / "none.db", Store::Access::read),
                HasSubstr("none.db: there is no such results store"));
    EXPECT_FALSE(std::filesystem::exists(folder / "none.db"));
}

TEST(Store, NoticesDamage) {
    const TestFolder folder;
    fresh(folder / "results.db").append(sample_results());
    std::string bytes = read_file(folder / "results.db");
    for (std::size_t i = 4096; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 37);
    write_file(folder / "results.db", bytes);
    EXPECT_THAT(error_of([&] { (void)Store(folder / "results.db", Store::Access::read).load(1); }),
                HasSubstr("results.db: not a results store, or damaged"));

    fresh(folder / "row.db").append(sample_results());
    Other(folder / "row.db").run("UPDATE claims SET json = '{}' WHERE position = 3");
    EXPECT_THAT(error_of([&] { (void)Store(folder / "row.db", Store::Access::read).load(1); }),
                HasSubstr("row.db: run 1: claims: not the JSON of a claim"));
}

TEST(Store, RefusesANewerSchema) {
    const TestFolder folder;
    fresh(folder / "results.db").append(sample_results());
    Other(folder / "results.db").run("PRAGMA user_version = 99");
    EXPECT_THAT(open_error(folder / "results.db", Store::Access::read),
                AllOf(HasSubstr("results.db: written by a newer plumb"), HasSubstr("schema 99")));
    Other(folder / "results.db").run("PRAGMA user_version = 1");
    EXPECT_THAT(open_error(folder / "results.db"), HasSubstr("results.db: written by an older plumb (schema 1"));
}

TEST(Store, NamesTheFileThatCannotBeMade) {
    EXPECT_THAT(open_error("/proc/results.db"), HasSubstr("/proc/results.db: cannot be"));
    EXPECT_THAT(open_error("/proc/plumb/results.db"), HasSubstr("/proc/plumb/results.db: its folder cannot be made"));
}

}  // namespace
}  // namespace plumb::reports
