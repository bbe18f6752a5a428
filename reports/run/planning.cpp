#include "reports/run/planning.h"

#include <iterator>
#include <set>
#include <sstream>

#include "core/error.h"
#include "core/random.h"
#include "core/version.h"

namespace plumb::reports {
namespace {

// Two runs whose claims or shares differ must not be mixed.
std::string fingerprint(const Catalogue& catalogue, const std::vector<Item>& items, Size size) {
    std::string all;
    for (const Item& item : items)
        all += fmt::format("{} {} {}\n", item.position, item.id(), catalogue.share(*item.claim, size));
    return fmt::format("{:016x}", stream_id(all));
}

std::vector<ErratumEntry> errata_of(const Catalogue& catalogue) {
    std::vector<ErratumEntry> entries;
    for (const Erratum& e : catalogue.errata()) entries.push_back({e.source, e.printed, e.correct, e.claim});
    return entries;
}

void append(Results& results, Judged one, double alpha_share) {
    const Claim& claim = *one.claim;
    if (one.mutant) {
        const bool killed = one.verdict.outcome == Outcome::refuted;
        results.mutants.push_back(
            {one.id(), claim.id, one.mutant->defect, std::move(one.verdict), killed, one.seconds, one.position});
    } else {
        results.claims.push_back({claim.id, claim.statement, claim.source, claim.kind, std::move(one.verdict),
                                  alpha_share, one.seconds, claim.no_mutant, one.position});
    }
}

}  // namespace

Size size_of(const RunInfo& run) {
    return run.size == "full" ? Size::full : Size::quick;
}

std::vector<std::string> patterns_of(const RunInfo& run) {
    std::istringstream words(run.patterns);
    return {std::istream_iterator<std::string>(words), {}};
}

StoredRun newest_unfinished(const Store& store, const std::string& file, bool judging) {
    const std::vector<StoredRun> runs = store.runs();
    const auto found = std::find_if(runs.rbegin(), runs.rend(), [&](const StoredRun& r) {
        return !r.run.finished && judges_claims(r.run) == judging;
    });
    if (found == runs.rend()) throw Error(fmt::format("{}: no run is unfinished: there is nothing to resume", file));
    if (found->run.version != version)
        throw Error(fmt::format("{}: run {} was begun by version {}; only that one can go on with it, this is {}", file,
                                found->id, found->run.version, version));
    return *found;
}

RunPlan begin_run(const Catalogue& catalogue, RunInfo run, const std::vector<std::string>& patterns,
                  const std::string& store) {
    RunPlan plan{std::move(run)};
    plan.run.patterns = fmt::format("{}", fmt::join(patterns, " "));
    const std::vector<Item> selected = select(catalogue, size_of(plan.run), patterns);
    plan.run.selected = selected.size();
    plan.run.fingerprint = fingerprint(catalogue, selected, size_of(plan.run));
    plan.items = shard_of(selected, {plan.run.shard, plan.run.shards});
    plan.number = Store(store, Store::Access::append).begin(plan.run, errata_of(catalogue));
    return plan;
}

RunPlan unfinished_run(const Catalogue& catalogue, const std::string& file) {
    const Store store(file, Store::Access::read);
    const StoredRun stored = newest_unfinished(store, file, true);
    RunPlan plan{stored.run, stored.id};
    plan.items = select(catalogue, size_of(plan.run), patterns_of(plan.run));
    if (fingerprint(catalogue, plan.items, size_of(plan.run)) != plan.run.fingerprint)
        throw Error(
            fmt::format("{}: the claims have changed since run {} was begun; verify them anew", file, plan.number));
    plan.items = shard_of(std::move(plan.items), {plan.run.shard, plan.run.shards});
    const Results results = store.load(plan.number);
    std::set<std::uint64_t> judged;
    for (const ClaimResult& claim : results.claims) judged.insert(claim.position);
    for (const MutantResult& mutant : results.mutants) judged.insert(mutant.position);
    plan.done = std::erase_if(plan.items, [&](const Item& item) { return judged.contains(item.position); });
    return plan;
}

Results results_of(std::vector<Judged> judged, const Catalogue& catalogue, const RunInfo& run) {
    Results results;
    for (Judged& one : judged) {
        const double share = run.alpha * catalogue.share(*one.claim, size_of(run));
        append(results, std::move(one), share);
    }
    return results;
}

}  // namespace plumb::reports
