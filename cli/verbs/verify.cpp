#include <CLI/CLI.hpp>
#include <chrono>

#include "checks/sampler/sampler.h"
#include "cli/common_options.h"
#include "cli/judge_watched.h"
#include "cli/session.h"
#include "cli/stop_signal.h"
#include "cli/values.h"
#include "cli/verb.h"
#include "cli/verbs/outputs.h"
#include "cli/verbs/verify.h"
#include "core/error.h"
#include "core/error_target.h"
#include "core/random.h"
#include "core/shard.h"
#include "core/version.h"
#include "reports/run/planning.h"
#include "reports/run/store.h"

namespace plumb::cli {
namespace verbs {
namespace {

struct Options : Outputs {
    std::vector<std::string> patterns;
    bool full = false;
    double alpha = 1e-4;
    std::optional<std::chrono::duration<double>> time_limit;
    std::optional<std::uint64_t> seed;  ///< empty: a new one
    int threads = 0;                    ///< 0: as many as the hardware has
    Shard shard;
    bool resume = false;           ///< the newest unfinished run of the store, whose settings stand
    checks::SamplerTrial sampler;  ///< instead of the catalogue; without a command: none
    bool report_given = false;     ///< --report; without it a part has a page of its own
};

// The page of a part does not take the place of that of the whole.
constexpr const char* report_of_a_part = "out/report-part.html";

// The run that the options ask for, begun or gone on with.
reports::RunPlan plan_of(const Options& options, const Catalogue& catalogue) {
    if (options.resume) return reports::unfinished_run(catalogue, options.store);
    reports::RunInfo run = Session(options.seed, options.threads).run;
    run.alpha = options.alpha;
    run.size = options.full ? "full" : "quick";
    run.shard = options.shard.index;
    run.shards = options.shard.count;
    return reports::begin_run(catalogue, std::move(run), options.patterns, options.store);
}

// Judges and stores what is left of the plan; returns the signal that ended it early, 0 for none.
int carry_out(const reports::RunPlan& plan, const Catalogue& catalogue, const Options& options, reports::Store& store) {
    const RunSetting setting{.seed = plan.run.seed,
                             .alpha = plan.run.alpha,
                             .size = size_of(plan.run),
                             .time_limit = options.time_limit,
                             .threads = options.threads > 0 ? options.threads : plan.run.threads};
    const auto start = std::chrono::steady_clock::now();
    std::size_t done = plan.done;
    const std::size_t total = plan.done + plan.items.size();
    ProgressLine line;
    const auto keep = [&](std::vector<Judged> judged) {
        done += judged.size();
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        const double share = static_cast<double>(done - plan.done) / static_cast<double>(plan.items.size());
        line.show(fmt::format("{}/{}{}: {} {}", done, total, time_left(elapsed.count(), share),
                              to_string(judged.back().verdict.outcome), judged.back().id()));
        const reports::Results results = reports::results_of(std::move(judged), catalogue, plan.run);
        store.add(plan.number, results.claims, results.mutants, plan.run.seconds + elapsed.count());
    };
    const auto farewell = [&](int signal) {
        line.clear();
        fmt::print(stderr,
                   "plumb: stopped by {}: {} of {} verdicts are kept in {}, run {}; `plumb verify --resume --store {}` "
                   "goes on\n",
                   name_of_signal(signal), done, total, options.store, plan.number, options.store);
    };
    return judge_watched(catalogue, plan.items, setting, keep, farewell);
}

int verify(Options options, const Catalogue& catalogue) {
    check_outputs(options);
    const reports::RunPlan plan = plan_of(options, catalogue);
    const bool part = !plan.run.patterns.empty() || plan.run.shards > 1 || !options.sampler.command.empty();
    if (part && !options.report_given) options.report = report_of_a_part;
    reports::Store store(options.store, reports::Store::Access::append);
    if (const int signal = carry_out(plan, catalogue, options, store)) return 128 + signal;
    store.finish(plan.number);
    return publish(store.load(plan.number), plan.number, options);
}

int verify_sampler(Options options) {
    check_outputs(options);  // before the sampler's work, not after it
    if (!options.seed) options.seed = fresh_seed();
    if (options.sampler.density.empty() && !options.sampler.mean)
        throw Error("--sampler: judged by what? Give --density, or --mean and --delta");
    return verify(options, checks::sampler_catalogue(options.sampler, *options.seed, options.alpha));
}

void add_sampler(CLI::App& verb, checks::SamplerTrial& trial) {
    CLI::Option* sampler = verb.add_option("--sampler", trial.command,
                                           "judge a program in another process instead: a command that prints {n} "
                                           "samples or values, one a line, from the seed {seed}");
    CLI::Option* density = verb.add_option(
        "--density", trial.density,
        "the sampler's density: a CSV file, or uniform, linear:A,B, exponential:RATE, uniform-2d, bilinear:A,B,C,D; "
        "own: as its lines say, x,pdf or x,y,pdf" +
            std::string(trial.formula ? "; or a formula of x (and y), which Plumb normalises" : ""));
    CLI::Option* mean = verb.add_option("--mean", trial.mean, "instead: the mean of the values that it prints");
    for (const char* other : {"patterns", "--full", "--shard", "--resume"}) sampler->excludes(verb.get_option(other));
    density->needs(sampler)->excludes(mean);
    mean->needs(sampler);
    add_parsed(verb, "--delta", trial.delta, parse_error_target,
               "the error that `holds` excludes: of a density (phi) 0.05 when not given; of a mean 1e-3 or 1%")
        ->needs(sampler);
    add_count(verb, "--samples", trial.samples, 1, trial.most_samples,
              "how many lines are asked for with --mean or --density own; other densities need what they need")
        ->needs(sampler);
    add_domain(verb, trial.domain);
    verb.get_option("--domain")->needs(density);
    add_parsed(verb, "--sampler-timeout", trial.timeout, parse_duration,
               "when a sampler that is not done is stopped; 60s when not given")
        ->needs(sampler);
}

}  // namespace

}  // namespace verbs

Action add_verify(CLI::App& verb, decltype(checks::SamplerTrial::formula) formula) {
    using namespace verbs;
    const auto options = std::make_shared<Options>();
    options->sampler.formula = std::move(formula);
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
    CLI::Option* report = verb.get_option("--report");
    report->description(report->get_description() + fmt::format("; of a part {}", report_of_a_part));
    return [options, report](const Catalogue& catalogue) {
        options->report_given = report->count() > 0;
        return options->sampler.command.empty() ? verify(*options, catalogue) : verify_sampler(*options);
    };
}

std::string reason_of_verify(const CLI::ParseError& error) {
    const std::string_view what = error.what();
    const auto says = [&](std::string_view words) { return what.find(words) != std::string_view::npos; };
    if (dynamic_cast<const CLI::ExcludesError*>(&error) && says("--resume") && says("--sampler"))
        return "samples are asked for anew each time: such a run is short";
    if (dynamic_cast<const CLI::ExcludesError*>(&error) && says("--resume"))
        return "a resumed run keeps the patterns, seed, alpha, size and shard that it began with";
    if (dynamic_cast<const CLI::RequiresError*>(&error) && what.starts_with("--shard requires"))
        return "all shards of a run must have the same seed";
    return {};
}

namespace verbs {

Verb verify() {
    return {"verify", "Judge claims and their mutants; write a report",
            [](CLI::App& verb) { return add_verify(verb, {}); }, reason_of_verify};
}

}  // namespace verbs
}  // namespace plumb::cli
