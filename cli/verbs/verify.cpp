#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <iterator>
#include <set>
#include <sstream>

#include "cli/common_options.h"
#include "cli/judge_watched.h"
#include "cli/sampler.h"
#include "cli/session.h"
#include "cli/values.h"
#include "cli/verb.h"
#include "cli/verbs/outputs.h"
#include "core/random.h"
#include "core/shard.h"
#include "core/version.h"
#include "reports/run/store.h"

namespace plumb::cli::verbs {
namespace {

struct Options : Outputs {
    std::vector<std::string> patterns;
    bool full = false;
    double alpha = 1e-4;
    std::optional<std::chrono::duration<double>> time_limit;
    std::optional<std::uint64_t> seed;  ///< empty: a new one
    int threads = 0;                    ///< 0: as many as the hardware has
    Shard shard;
    bool resume = false;   ///< the newest unfinished run of the store, whose settings stand
    SamplerTrial sampler;  ///< instead of the catalogue; without a command: none
};

/// A run that is stored, and what of it is still to be judged.
struct Plan {
    reports::RunInfo run;
    std::int64_t number = 0;
    std::vector<Item> items = {};
    std::size_t done = 0;  ///< verdicts that are stored already
};

Size size_of(const reports::RunInfo& run) {
    return run.size == "full" ? Size::full : Size::quick;
}

std::vector<std::string> patterns_of(const reports::RunInfo& run) {
    std::istringstream words(run.patterns);
    return {std::istream_iterator<std::string>(words), {}};
}

// Two runs whose claims or shares differ must not be mixed.
std::string fingerprint(const Catalogue& catalogue, const std::vector<Item>& items, Size size) {
    std::string all;
    for (const Item& item : items)
        all += fmt::format("{} {} {}\n", item.position, item.id(), catalogue.share(*item.claim, size));
    return fmt::format("{:016x}", stream_id(all));
}

std::vector<reports::ErratumEntry> errata_of(const Catalogue& catalogue) {
    std::vector<reports::ErratumEntry> entries;
    for (const Erratum& e : catalogue.errata()) entries.push_back({e.source, e.printed, e.correct, e.claim});
    return entries;
}

Plan new_plan(const Catalogue& catalogue, const Options& options) {
    Plan plan{Session(options.seed, options.threads).run};
    plan.run.alpha = options.alpha;
    plan.run.size = options.full ? "full" : "quick";
    plan.run.patterns = fmt::format("{}", fmt::join(options.patterns, " "));
    plan.run.shard = options.shard.index;
    plan.run.shards = options.shard.count;
    const std::vector<Item> selected = select(catalogue, size_of(plan.run), options.patterns);
    plan.run.selected = selected.size();
    plan.run.fingerprint = fingerprint(catalogue, selected, size_of(plan.run));
    plan.items = shard_of(selected, options.shard);
    plan.number = reports::Store(options.store, reports::Store::Access::append).begin(plan.run, errata_of(catalogue));
    return plan;
}

Plan unfinished_plan(const Catalogue& catalogue, const Options& options) {
    const reports::Store store(options.store, reports::Store::Access::read);
    const std::vector<reports::StoredRun> runs = store.runs();
    const auto stored =
        std::find_if(runs.rbegin(), runs.rend(), [](const reports::StoredRun& r) { return !r.run.finished; });
    if (stored == runs.rend())
        throw Error(fmt::format("{}: no run is unfinished: there is nothing to resume", options.store));
    Plan plan{stored->run, stored->id};
    if (plan.run.version != version)
        throw Error(fmt::format("{}: run {} was begun by version {}; only that one can go on with it, this is {}",
                                options.store, plan.number, plan.run.version, version));
    plan.items = select(catalogue, size_of(plan.run), patterns_of(plan.run));
    if (fingerprint(catalogue, plan.items, size_of(plan.run)) != plan.run.fingerprint)
        throw Error(fmt::format("{}: the claims have changed since run {} was begun; verify them anew", options.store,
                                plan.number));
    plan.items = shard_of(std::move(plan.items), {plan.run.shard, plan.run.shards});
    const reports::Results results = store.load(plan.number);
    std::set<std::uint64_t> judged;
    for (const reports::ClaimResult& claim : results.claims) judged.insert(claim.position);
    for (const reports::MutantResult& mutant : results.mutants) judged.insert(mutant.position);
    plan.done = std::erase_if(plan.items, [&](const Item& item) { return judged.contains(item.position); });
    return plan;
}

void append(reports::Results& results, Judged one, double alpha_share) {
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

// Judges and stores what is left of the plan; returns the signal that ended it early, 0 for none.
int carry_out(const Plan& plan, const Catalogue& catalogue, const Options& options, reports::Store& store) {
    const Size size = size_of(plan.run);
    const RunSetting setting{.seed = plan.run.seed,
                             .alpha = plan.run.alpha,
                             .size = size,
                             .time_limit = options.time_limit,
                             .threads = options.threads > 0 ? options.threads : plan.run.threads};
    const auto start = std::chrono::steady_clock::now();
    std::size_t done = plan.done;
    const std::size_t total = plan.done + plan.items.size();
    ProgressLine line;
    const auto keep = [&](std::vector<Judged> judged) {
        done += judged.size();
        line.show(
            fmt::format("{}/{} {} {}", done, total, to_string(judged.back().verdict.outcome), judged.back().id()));
        reports::Results results;
        for (Judged& one : judged) {
            const double share = plan.run.alpha * catalogue.share(*one.claim, size);
            append(results, std::move(one), share);
        }
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        store.add(plan.number, results.claims, results.mutants, plan.run.seconds + elapsed.count());
    };
    const auto farewell = [&](int signal) {
        line.clear();
        fmt::print(stderr,
                   "plumb: stopped by {}: {} of {} verdicts are kept in {}, run {}; `plumb verify --resume --store {}` "
                   "goes on\n",
                   signal == SIGINT ? "SIGINT" : "SIGTERM", done, total, options.store, plan.number, options.store);
    };
    return judge_watched(catalogue, plan.items, setting, keep, farewell);
}

int verify(const Options& options, const Catalogue& catalogue) {
    check_outputs(options);
    const Plan plan = options.resume ? unfinished_plan(catalogue, options) : new_plan(catalogue, options);
    reports::Store store(options.store, reports::Store::Access::append);
    if (const int signal = carry_out(plan, catalogue, options, store)) return 128 + signal;
    store.finish(plan.number);
    return publish(store.load(plan.number), plan.number, options);
}

int verify_sampler(Options options) {
    check_outputs(options);  // before the sampler's work, not after it
    if (!options.seed) options.seed = fresh_seed();
    return verify(options, sampler_catalogue(options.sampler, *options.seed, options.alpha));
}

void add_sampler(CLI::App& verb, SamplerTrial& trial) {
    CLI::Option* sampler = verb.add_option("--sampler", trial.command,
                                           "judge a sampler in another process instead: a command that prints {n} "
                                           "samples, one a line, from the seed {seed}");
    CLI::Option* density =
        verb.add_option("--density", trial.density,
                        "the sampler's density: a CSV file, or uniform, linear:A,B, exponential:RATE, uniform-2d, "
                        "bilinear:A,B,C,D");
    sampler->needs(density);
    for (const char* other : {"patterns", "--full", "--shard", "--resume"}) sampler->excludes(verb.get_option(other));
    density->needs(sampler);
    verb.add_option("--delta", trial.delta, "the density error (phi) that `holds` excludes")
        ->check(probability())
        ->needs(sampler)
        ->capture_default_str();
    add_parsed(verb, "--sampler-timeout", trial.timeout, parse_duration,
               "when a sampler that is not done is stopped; 60s when not given")
        ->needs(sampler);
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    CLI::Option* patterns =
        verb.add_option("patterns", options->patterns, "claims to judge, e.g. 'reweighting/*'; all when none is given");
    CLI::Option* full =
        verb.add_flag("--full", options->full, "the full size of every claim (about 20 times the work)");
    CLI::Option* alpha = verb.add_option("--alpha", options->alpha, "false-alarm budget of the whole run")
                             ->check(probability())
                             ->capture_default_str();
    add_parsed(verb, "--time-limit", options->time_limit, parse_duration,
               "stop drawing after this long, e.g. 60s: what is open then is undecided");
    add_seed_and_threads(verb, options->seed, options->threads);
    CLI::Option* seed = verb.get_option("--seed");
    CLI::Option* shard = add_parsed(verb, "--shard", options->shard, parse_shard,
                                    "judge the i-th of n parts, i/n; plumb merge joins them. Needs --seed")
                             ->needs(seed);
    CLI::Option* resume =
        verb.add_flag("--resume", options->resume, "go on with the store's newest unfinished run, with its settings");
    for (CLI::Option* setting : {patterns, full, alpha, seed, shard}) resume->excludes(setting);
    add_outputs(verb, *options);
    add_sampler(verb, options->sampler);
    verb.footer(
        "Exit code: 0 every claim holds and every mutant is refuted, 1 a claim refuted or a mutant alive,\n"
        "2 usage or input error, 3 something undecided; 130 or 143 when SIGINT or SIGTERM ended it: what was judged\n"
        "is stored, and --resume goes on.\n\n"
        "Example: plumb verify 'reweighting/*' 'points/*' --json verdicts.json");
    return [options](const Catalogue& catalogue) {
        return options->sampler.command.empty() ? verify(*options, catalogue) : verify_sampler(*options);
    };
}

std::string reason(const CLI::ParseError& error) {
    const std::string_view what = error.what();
    if (dynamic_cast<const CLI::ExcludesError*>(&error) && what.find("--resume") != std::string_view::npos)
        return "a resumed run keeps the patterns, seed, alpha, size and shard that it began with";
    if (dynamic_cast<const CLI::RequiresError*>(&error) && what.find("--shard") != std::string_view::npos)
        return "all shards of a run must have the same seed";
    return {};
}

}  // namespace

Verb verify() {
    return {"verify", "Judge claims and their mutants; write a report", add, reason};
}

}  // namespace plumb::cli::verbs
