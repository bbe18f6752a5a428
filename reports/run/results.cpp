#include "reports/run/results.h"

#include <fmt/format.h>

#include <cmath>

namespace plumb::reports {

namespace {

void forget_seconds(std::vector<Series>& list) {
    for (Series& series : list)
        for (ConvergencePoint& point : series.points) point.seconds = 0;
}

}  // namespace

bool judges_claims(const RunInfo& run) {
    return !std::isnan(run.alpha);
}

std::string_view verb_of(const RunInfo& run) {
    return judges_claims(run) ? "verify" : "reproduce";
}

Results without_side_records(Results results) {
    results.run.started.clear();
    results.run.threads = 1;
    results.run.seconds = 0;
    forget_seconds(results.series);
    for (ClaimResult& claim : results.claims) {
        claim.seconds = 0;
        forget_seconds(claim.verdict.series);
    }
    for (MutantResult& mutant : results.mutants) {
        mutant.seconds = 0;
        forget_seconds(mutant.verdict.series);
    }
    return results;
}

Tally tally(const Results& results) {
    Tally t;
    for (const ClaimResult& claim : results.claims) switch (claim.verdict.outcome) {
            case Outcome::holds: ++t.holds; break;
            case Outcome::refuted: ++t.refuted; break;
            case Outcome::undecided: ++t.undecided; break;
        }
    t.mutants = results.mutants.size();
    for (const MutantResult& mutant : results.mutants) t.killed += mutant.killed ? 1 : 0;
    return t;
}

std::string summary_line(const Results& results) {
    const Tally t = tally(results);
    return fmt::format("{} hold, {} refuted, {} undecided; mutants: {} of {} refuted", t.holds, t.refuted, t.undecided,
                       t.killed, t.mutants);
}

}  // namespace plumb::reports
