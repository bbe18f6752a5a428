#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "verification/verdict.h"

namespace plumb::reports {

/// The settings of a run and how long it took. `started` and `seconds` are side records: no verdict depends on them.
struct RunInfo {
    std::uint64_t seed = 0;
    double alpha = std::numeric_limits<double>::quiet_NaN();  ///< the false-alarm budget; NaN where nothing was decided
    int threads = 1;
    std::string size = "quick";  ///< "quick" or "full"
    std::string version;         ///< of Plumb
    std::string started;         ///< ISO 8601, UTC: 2025-01-31T23:59:59Z
    std::string patterns;        ///< what was selected, separated by spaces; empty for everything
    int shard = 1, shards = 1;   ///< the run is the shard-th of so many parts
    std::uint64_t selected = 0;  ///< claims and mutants that all parts judge together
    std::string fingerprint;     ///< of what was selected, with its shares: runs of different claims do not join
    bool finished = true;        ///< false while it goes on, or when it was interrupted
    double seconds = 0;          ///< wall clock
};

/// False of a run that measures figures instead (`plumb reproduce`): it has no false-alarm budget.
bool judges_claims(const RunInfo& run);
/// The name of the verb that makes such runs.
std::string_view verb_of(const RunInfo& run);

struct ClaimResult {
    std::string id, statement, source;
    Kind kind = Kind::exact;
    Verdict verdict;
    double alpha_share = 0;  ///< the claim's share of the false-alarm budget, absolute
    double seconds = 0;
    std::string no_mutant;       ///< why no mutant is possible, where there is none
    std::uint64_t position = 0;  ///< among the claims and mutants that were selected, in catalogue order
};

/// A mutant with its verdict, as a report shows it.
struct MutantResult {
    std::string id;      ///< claim-id/mutant-id
    std::string of;      ///< the claim that must refute it
    std::string defect;  ///< one sentence
    Verdict verdict;
    bool killed = false;  ///< the claim refuted it
    double seconds = 0;
    std::uint64_t position = 0;  ///< as above
};

/// A statement of a source that is wrong, what is right instead, and the claim that shows it.
struct ErratumEntry {
    std::string source, printed, correct, claim;
};

/// Everything a run found: the one value that tables, JSON, the store and the page render.
struct Results {
    RunInfo run = {};
    std::vector<ClaimResult> claims = {};
    std::vector<MutantResult> mutants = {};
    std::vector<ErratumEntry> errata = {};
    std::vector<Series> series = {};  ///< convergence that belongs to no claim (`plumb converge`)
};

/// The results less what may differ between two runs of one seed: when, how long, on how many threads.
Results without_side_records(Results results);

/// The number of claims by outcome, of mutants, and of mutants that were refuted.
struct Tally {
    std::size_t holds = 0, refuted = 0, undecided = 0;
    std::size_t mutants = 0, killed = 0;
};
Tally tally(const Results& results);

/// The outcomes in one line: `12 hold, 0 refuted, 1 undecided; mutants: 25 of 25 refuted`.
std::string summary_line(const Results& results);

}  // namespace plumb::reports
