#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "reports/run/results.h"

namespace plumb::reports {

namespace sqlite {
class Database;
}

/// A run as the store lists it.
struct StoredRun {
    std::int64_t id = 0;
    RunInfo run;
    Tally tally;
};

/// The results of all runs in one SQLite file, whose tables store.cpp describes. Every function throws Error, naming
/// the file, when it is locked, damaged, written by a newer Plumb, another program's, or cannot be written. What a
/// killed process left half written is undone by the next one that opens the file, to read or to append.
class Store {
public:
    enum class Access {
        read,    ///< the file must be there
        append,  ///< the file and its folder are made when missing
    };
    /// Opens the file; `patience` is how long to wait for another process that is writing.
    Store(const std::filesystem::path& file, Access access,
          std::chrono::milliseconds patience = std::chrono::seconds(5));
    ~Store();

    /// Stores a run in one transaction and returns its number: 1, 2, …
    std::int64_t append(const Results& results);

    /// Stores a run as it goes: it begins unfinished and empty, and returns its number; verdicts and series are added
    /// as they come, in any order (what is there already is left as it is); finish() marks it as complete.
    std::int64_t begin(const RunInfo& run, const std::vector<ErratumEntry>& errata);
    /// Adds in one transaction; `seconds` is what the run has taken so far.
    void add(std::int64_t run, const std::vector<ClaimResult>& claims, const std::vector<MutantResult>& mutants,
             double seconds);
    /// Adds series in one transaction, the first of which is number `position` of the run's.
    void add(std::int64_t run, std::uint64_t position, const std::vector<Series>& series, double seconds);
    void finish(std::int64_t run);

    /// The results of a run. Throws Error for a number that is not there, naming the last one that is.
    [[nodiscard]] Results load(std::int64_t run) const;
    /// All runs, oldest first.
    [[nodiscard]] std::vector<StoredRun> runs() const;

private:
    std::unique_ptr<sqlite::Database> database_;
};

}  // namespace plumb::reports
