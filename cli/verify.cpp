#include <chrono>

#include "cli/commands.h"
#include "cli/run_info.h"
#include "reports/file.h"
#include "reports/html.h"
#include "reports/json.h"
#include "reports/store.h"
#include "reports/table.h"
#include "verification/runner.h"

namespace plumb {
namespace {

Results to_results(RunInfo run, const Catalogue& catalogue, std::vector<Judged> judged, Size size) {
    Results results;
    for (Judged& one : judged) {
        const Claim& claim = *one.claim;
        if (one.mutant) {
            const bool killed = one.verdict.outcome == Outcome::refuted;
            results.mutants.push_back(
                {one.id(), claim.id, one.mutant->defect, std::move(one.verdict), killed, one.seconds});
        } else {
            const double share = run.alpha * catalogue.share(claim, size);
            results.claims.push_back({claim.id, claim.statement, claim.source, claim.kind, std::move(one.verdict),
                                      share, one.seconds, claim.no_mutant});
        }
    }
    for (const Erratum& erratum : catalogue.errata())
        results.errata.push_back({erratum.source, erratum.printed, erratum.correct, erratum.claim});
    results.run = std::move(run);
    return results;
}

int exit_code(const Results& results) {
    const auto claims = [&](Outcome outcome) {
        return std::ranges::any_of(results.claims, [&](const ClaimResult& c) { return c.verdict.outcome == outcome; });
    };
    const auto mutants = [&](Outcome outcome) {
        return std::ranges::any_of(results.mutants,
                                   [&](const MutantResult& m) { return m.verdict.outcome == outcome; });
    };
    if (claims(Outcome::refuted) || mutants(Outcome::holds)) return 1;
    if (claims(Outcome::undecided) || mutants(Outcome::undecided)) return 3;
    return 0;
}

}  // namespace

int verify(const VerifyOptions& options, const Catalogue& catalogue) {
    RunInfo run = start_run(options.seed, options.threads);
    run.alpha = options.alpha;
    run.size = options.full ? "full" : "quick";
    run.patterns = fmt::format("{}", fmt::join(options.patterns, " "));
    Store store(options.store, Store::Access::append);  // a store that cannot be written is found before the work

    const RunSetting setting{.seed = run.seed,
                             .alpha = options.alpha,
                             .size = options.full ? Size::full : Size::quick,
                             .patterns = options.patterns,
                             .time_limit = options.time_limit,
                             .threads = run.threads};
    const auto start = std::chrono::steady_clock::now();
    std::vector<Judged> judged;
    {
        ProgressLine line;
        judged = judge(catalogue, setting, [&](const Judged& one, std::size_t done, std::size_t total) {
            line.show(fmt::format("{}/{} {} {}", done, total, to_string(one.verdict.outcome), one.id()));
        });
    }
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    const Results results = to_results(std::move(run), catalogue, std::move(judged), setting.size);
    if (!options.json.empty()) write_file(options.json, to_json(results));
    write_report(results, {}, options.report);
    const std::int64_t number = store.append(results);
    fmt::print("{}", verdict_table(results, terminal_style()));
    for (const ClaimResult& claim : results.claims)  // what the table's width may have cut off
        if (claim.verdict.outcome != Outcome::holds) fmt::print("{}: {}\n", claim.id, describe(claim.verdict));
    fmt::print("run {} in {}, seed {}, {:.1f} s; report: {}\n", number, options.store, results.run.seed,
               results.run.seconds, options.report);
    return exit_code(results);
}

}  // namespace plumb
