#include "reports/run/store.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <system_error>

#include "core/error.h"
#include "core/numbers.h"
#include "reports/run/json.h"
#include "reports/run/sqlite.h"

namespace plumb::reports {
namespace {

namespace fs = std::filesystem;
using sqlite::Database, sqlite::Statement, sqlite::Transaction;

constexpr std::int64_t application_id = 0x706c6d62;  // "plmb": tells our file from another program's database
constexpr std::int64_t schema_version = 2;

// Claims, mutants and series are stored as the JSON that docs/json.md describes; what one may want to query by SQL
// stands in columns of its own. The seed is text, because SQLite's integers are signed.
constexpr const char* schema = R"(
    CREATE TABLE runs (run INTEGER PRIMARY KEY, seed TEXT NOT NULL, alpha REAL, threads INTEGER NOT NULL,
        size TEXT NOT NULL, version TEXT NOT NULL, started TEXT NOT NULL, patterns TEXT NOT NULL,
        shard INTEGER NOT NULL, shards INTEGER NOT NULL, selected INTEGER NOT NULL, fingerprint TEXT NOT NULL,
        finished INTEGER NOT NULL, seconds REAL);
    CREATE TABLE claims (run INTEGER NOT NULL REFERENCES runs, position INTEGER NOT NULL, id TEXT NOT NULL,
        kind TEXT NOT NULL, outcome TEXT NOT NULL, samples INTEGER NOT NULL, seconds REAL, json TEXT NOT NULL,
        PRIMARY KEY (run, position)) WITHOUT ROWID;
    CREATE TABLE mutants (run INTEGER NOT NULL REFERENCES runs, position INTEGER NOT NULL, id TEXT NOT NULL,
        of TEXT NOT NULL, outcome TEXT NOT NULL, killed INTEGER NOT NULL, json TEXT NOT NULL,
        PRIMARY KEY (run, position)) WITHOUT ROWID;
    CREATE TABLE errata (run INTEGER NOT NULL REFERENCES runs, position INTEGER NOT NULL, source TEXT NOT NULL,
        printed TEXT NOT NULL, correct TEXT NOT NULL, claim TEXT NOT NULL, PRIMARY KEY (run, position)) WITHOUT ROWID;
    CREATE TABLE series (run INTEGER NOT NULL REFERENCES runs, position INTEGER NOT NULL, estimator TEXT NOT NULL,
        integrand TEXT NOT NULL, json TEXT NOT NULL, PRIMARY KEY (run, position)) WITHOUT ROWID;
)";

std::unique_ptr<Database> open(const fs::path& file, Store::Access access, std::chrono::milliseconds patience) {
    const bool append = access == Store::Access::append;
    std::error_code error;
    if (append && file.has_parent_path()) fs::create_directories(file.parent_path(), error);
    if (error) throw Error(fmt::format("{}: its folder cannot be made: {}", file.string(), error.message()));
    if (!append && !fs::exists(file, error))
        throw Error(fmt::format("{}: there is no such results store; `plumb verify` makes one", file.string()));
    // Who reads may have to undo what a killed writer left half written (SQLite's hot journal), so may write as well;
    // where the file's permissions forbid that, SQLite opens it for reading alone.
    const int flags = SQLITE_OPEN_READWRITE | (append ? SQLITE_OPEN_CREATE : 0);
    return std::make_unique<Database>(file, flags, static_cast<int>(patience.count()));
}

bool is_empty(const Database& database) {
    return !Statement(database, "SELECT 1 FROM sqlite_schema").step();
}

void create_schema(const Database& database) {
    Transaction transaction(database);
    if (!is_empty(database)) return;  // another process was faster
    database.execute(schema);
    database.execute(
        fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", application_id, schema_version));
    transaction.commit();
}

void check_schema(const Database& database) {
    if (is_empty(database))
        throw Error(fmt::format("{}: no run was stored in it; `plumb verify --store {}` begins one",
                                database.file().string(), database.file().string()));
    if (database.pragma("application_id") != application_id)
        throw Error(fmt::format("{}: a SQLite database, but not a results store", database.file().string()));
    if (const std::int64_t version = database.pragma("user_version"); version != schema_version)
        throw Error(fmt::format("{}: written by {} plumb (schema {}; this one knows {})", database.file().string(),
                                version > schema_version ? "a newer" : "an older", version, schema_version));
}

std::int64_t add_run(const Database& database, const RunInfo& run) {
    Statement(database, "INSERT INTO runs VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .with(std::to_string(run.seed), run.alpha, std::int64_t{run.threads}, run.size, run.version, run.started,
              run.patterns, std::int64_t{run.shard}, std::int64_t{run.shards}, static_cast<std::int64_t>(run.selected),
              run.fingerprint, std::int64_t{run.finished}, run.seconds)
        .step();
    return sqlite3_last_insert_rowid(database.handle());
}

std::uint64_t seed_from(const Statement& row, int column) {
    const std::string text = row.text(column);
    const auto seed = number_of<std::uint64_t>(text);
    if (!seed)
        throw Error(fmt::format("{}: run {} has the seed '{}', which is no number", row.database().file().string(),
                                row.integer(0), text));
    return *seed;
}

RunInfo run_info(const Statement& row) {  // of a query for runs.*
    return {.seed = seed_from(row, 1),
            .alpha = row.real(2),
            .threads = static_cast<int>(row.integer(3)),
            .size = row.text(4),
            .version = row.text(5),
            .started = row.text(6),
            .patterns = row.text(7),
            .shard = static_cast<int>(row.integer(8)),
            .shards = static_cast<int>(row.integer(9)),
            .selected = static_cast<std::uint64_t>(row.integer(10)),
            .fingerprint = row.text(11),
            .finished = row.integer(12) != 0,
            .seconds = row.real(13)};
}

void add_claims(const Database& database, std::int64_t run, const std::vector<ClaimResult>& claims) {
    Statement insert(database, "INSERT INTO claims VALUES (?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING");
    for (const ClaimResult& claim : claims)
        insert
            .with(run, static_cast<std::int64_t>(claim.position), claim.id, to_string(claim.kind),
                  to_string(claim.verdict.outcome), static_cast<std::int64_t>(claim.verdict.samples), claim.seconds,
                  claim_json(claim))
            .step();
}

void add_mutants(const Database& database, std::int64_t run, const std::vector<MutantResult>& mutants) {
    Statement insert(database, "INSERT INTO mutants VALUES (?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING");
    for (const MutantResult& mutant : mutants)
        insert
            .with(run, static_cast<std::int64_t>(mutant.position), mutant.id, mutant.of,
                  to_string(mutant.verdict.outcome), std::int64_t{mutant.killed}, mutant_json(mutant))
            .step();
}

void add_errata(const Database& database, std::int64_t run, const std::vector<ErratumEntry>& errata) {
    Statement insert(database, "INSERT INTO errata VALUES (?, ?, ?, ?, ?, ?)");
    std::int64_t position = 0;
    for (const ErratumEntry& e : errata) insert.with(run, position++, e.source, e.printed, e.correct, e.claim).step();
}

void add_series(const Database& database, std::int64_t run, std::int64_t position, const std::vector<Series>& series) {
    Statement insert(database, "INSERT INTO series VALUES (?, ?, ?, ?, ?) ON CONFLICT DO NOTHING");
    for (const Series& s : series) insert.with(run, position++, s.estimator, s.integrand, series_json(s)).step();
}

void set_seconds(const Database& database, std::int64_t run, double seconds) {
    Statement(database, "UPDATE runs SET seconds = ? WHERE run = ?").with(seconds, run).step();
}

/// The JSON column of a run's rows in one of the tables, read back.
template <class Read>
auto rows(const Database& database, const char* table, std::int64_t run, const Read& read) {
    const std::string name = fmt::format("{}: run {}: {}", database.file().string(), run, table);
    Statement select(database, fmt::format("SELECT json, position FROM {} WHERE run = ? ORDER BY position", table));
    select.with(run);
    std::vector<decltype(read(std::string_view(), std::string_view()))> found;
    while (select.step()) {
        found.push_back(read(select.text(0), name));
        if constexpr (requires { found.back().position; })
            found.back().position = static_cast<std::uint64_t>(select.integer(1));
    }
    return found;
}

}  // namespace

Store::Store(const fs::path& file, Access access, std::chrono::milliseconds patience)
    : database_(open(file, access, patience)) {
    if (access == Access::append && is_empty(*database_)) try {
            create_schema(*database_);
        } catch (const Error&) {
            std::error_code error;
            if (fs::file_size(file, error) == 0 && !error) fs::remove(file, error);
            throw;
        }
    check_schema(*database_);
}

Store::~Store() = default;

std::int64_t Store::append(const Results& results) {
    Transaction transaction(*database_);
    const std::int64_t run = add_run(*database_, results.run);
    add_claims(*database_, run, results.claims);
    add_mutants(*database_, run, results.mutants);
    add_errata(*database_, run, results.errata);
    add_series(*database_, run, 0, results.series);
    transaction.commit();
    return run;
}

std::int64_t Store::begin(const RunInfo& run, const std::vector<ErratumEntry>& errata) {
    Transaction transaction(*database_);
    const std::int64_t number = add_run(*database_, run);
    add_errata(*database_, number, errata);
    Statement(*database_, "UPDATE runs SET finished = 0 WHERE run = ?").with(number).step();
    transaction.commit();
    return number;
}

void Store::add(std::int64_t run, const std::vector<ClaimResult>& claims, const std::vector<MutantResult>& mutants,
                double seconds) {
    Transaction transaction(*database_);
    add_claims(*database_, run, claims);
    add_mutants(*database_, run, mutants);
    set_seconds(*database_, run, seconds);
    transaction.commit();
}

void Store::add(std::int64_t run, std::uint64_t position, const std::vector<Series>& series, double seconds) {
    Transaction transaction(*database_);
    add_series(*database_, run, static_cast<std::int64_t>(position), series);
    set_seconds(*database_, run, seconds);
    transaction.commit();
}

void Store::finish(std::int64_t run) {
    Statement(*database_, "UPDATE runs SET finished = 1 WHERE run = ?").with(run).step();
}

Results Store::load(std::int64_t run) const {
    Statement select(*database_, "SELECT * FROM runs WHERE run = ?");
    if (!select.with(run).step()) {
        Statement last(*database_, "SELECT max(run) FROM runs");
        last.step();
        throw Error(fmt::format("{}: there is no run {}; the last one is {}", database_->file().string(), run,
                                last.integer(0)));
    }
    Results results{.run = run_info(select)};
    results.claims = rows(*database_, "claims", run, claim_from_json);
    results.mutants = rows(*database_, "mutants", run, mutant_from_json);
    results.series = rows(*database_, "series", run, series_from_json);
    Statement errata(*database_, "SELECT source, printed, correct, claim FROM errata WHERE run = ? ORDER BY position");
    errata.with(run);
    while (errata.step()) results.errata.push_back({errata.text(0), errata.text(1), errata.text(2), errata.text(3)});
    return results;
}

std::vector<StoredRun> Store::runs() const {
    Statement select(*database_, R"(SELECT runs.*,
        (SELECT count(*) FROM claims c WHERE c.run = runs.run AND c.outcome = 'holds'),
        (SELECT count(*) FROM claims c WHERE c.run = runs.run AND c.outcome = 'refuted'),
        (SELECT count(*) FROM claims c WHERE c.run = runs.run AND c.outcome = 'undecided'),
        (SELECT count(*) FROM mutants m WHERE m.run = runs.run),
        (SELECT count(*) FROM mutants m WHERE m.run = runs.run AND m.killed)
        FROM runs ORDER BY run)");
    std::vector<StoredRun> found;
    while (select.step()) {
        const auto count = [&](int column) { return static_cast<std::size_t>(select.integer(column)); };
        found.push_back({select.integer(0), run_info(select), {count(14), count(15), count(16), count(17), count(18)}});
    }
    return found;
}

}  // namespace plumb::reports
