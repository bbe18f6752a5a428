#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "reports/results.h"

struct sqlite3;

namespace plumb {

/// A run as the store lists it.
struct StoredRun {
    std::int64_t id = 0;
    RunInfo run;
    Tally tally;
};

/// The results of all runs, in one SQLite file; its tables are described in store.cpp. Every function throws Error,
/// naming the file, when it is locked, damaged, written by a newer Plumb, not ours, or cannot be written.
class Store {
public:
    enum class Access {
        read,    ///< the file must be there
        append,  ///< the file and its folder are made when missing
    };
    /// `patience` is how long to wait for another process that is writing.
    Store(std::filesystem::path file, Access access, std::chrono::milliseconds patience = std::chrono::seconds(5));

    /// Stores a run in one transaction and returns its number: 1, 2, …
    std::int64_t append(const Results& results);
    /// Throws Error for a number that is not there, naming those that are.
    [[nodiscard]] Results load(std::int64_t run) const;
    /// All runs, oldest first.
    [[nodiscard]] std::vector<StoredRun> runs() const;

private:
    struct Close {
        void operator()(sqlite3* database) const;
    };
    std::filesystem::path file_;
    std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace plumb
