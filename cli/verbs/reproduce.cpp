#include <CLI/CLI.hpp>
#include <chrono>

#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/stop_signal.h"
#include "cli/verb.h"
#include "cli/verbs/figure_outputs.h"
#include "cli/watched.h"
#include "core/parallel.h"
#include "core/shard.h"
#include "studies/measure.h"

namespace plumb::cli::verbs {
namespace {

struct Options : FigureOutputs {
    std::vector<std::string> patterns;
    bool full = false, resume = false;
    std::optional<std::uint64_t> seed;  ///< empty: a new one
    int threads = 0;                    ///< 0: as many as the hardware has
    Shard shard;
};

// The run that the options ask for, begun or gone on with.
ReproductionPlan plan_of(const Options& options) {
    if (options.resume) {
        const reports::Store store(options.store, reports::Store::Access::read);
        return resume_reproduction(shipped_tasks_of, store, options.store);
    }
    reports::RunInfo run = Session(options.seed, options.threads).run;
    run.size = options.full ? "full" : "quick";
    run.patterns = fmt::format("{}", fmt::join(options.patterns, " "));
    run.shard = options.shard.index;
    run.shards = options.shard.count;
    std::vector<FigureTask> tasks = shipped_tasks_of(run);
    reports::Store store(options.store, reports::Store::Access::append);
    return begin_reproduction(std::move(tasks), std::move(run), store);
}

double steps_left(const ReproductionPlan& plan) {
    std::size_t steps = 0;
    const std::vector<FigureTask> ours = tasks_of_shard(plan.tasks, {plan.run.shard, plan.run.shards});
    for (std::size_t i = plan.done; i < ours.size(); ++i) steps += steps_of(ours[i].plan);
    return static_cast<double>(steps);
}

// Measures and stores what is left of the plan; returns the signal that ended it early, 0 for none.
int carry_out(ReproductionPlan& plan, const Options& options, reports::Store& store) {
    ProgressLine line;
    const double steps = steps_left(plan);
    const auto start = std::chrono::steady_clock::now();
    double begun = 0;
    const auto show = [&](const std::string& what) {
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
        line.show(fmt::format("{}{}", what, time_left(spent.count(), begun++ / steps)));
    };
    const auto work = [&](const std::stop_token& stop) {
        with_threads(options.threads > 0 ? options.threads : plan.run.threads,
                     [&] { measure_left(plan, store, stop, show); });
    };
    const auto farewell = [&](int signal) {
        line.clear();
        fmt::print(stderr,
                   "plumb: stopped by {}: {} of {} figures are kept in {}, run {}; `plumb reproduce --resume --store "
                   "{}` goes on\n",
                   name_of_signal(signal), plan.done,
                   tasks_of_shard(plan.tasks, {plan.run.shard, plan.run.shards}).size(), options.store, plan.number,
                   options.store);
    };
    return watched(
        work, [] {}, farewell);
}

int reproduce(const Options& options) {
    check_outputs(options);
    ReproductionPlan plan = plan_of(options);
    reports::Store store(options.store, reports::Store::Access::append);
    if (const int signal = carry_out(plan, options, store)) return 128 + signal;
    return publish(plan.tasks, store.load(plan.number), plan.number, options);
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    CLI::Option* patterns =
        verb.add_option("patterns", options->patterns,
                        "studies or figures (STUDY/FIGURE) to measure, e.g. 'sequences/*'; all when none is given");
    CLI::Option* full = verb.add_flag("--full", options->full,
                                      "the replicates that each study asks for (about 10 times the work), not a tenth");
    add_seed_and_threads(verb, options->seed, options->threads);
    CLI::Option* seed = verb.get_option("--seed");
    CLI::Option* shard =
        add_parsed(verb, "--shard", options->shard, parse_shard,
                   "measure the i-th of n parts of the figures, i/n; plumb merge joins them. Needs --seed")
            ->needs(seed);
    CLI::Option* resume = verb.add_flag("--resume", options->resume,
                                        "go on with the store's newest unfinished reproduction, with its settings");
    for (CLI::Option* setting : {patterns, full, seed, shard}) resume->excludes(setting);
    verb.add_option("--out", options->out, "the folder that the page is written to; '' for none")
        ->capture_default_str();
    verb.add_option("--store", options->store, "the SQLite store that the run is added to")->capture_default_str();
    verb.footer(
        "Exit code: 0 whatever is met or not, as that is a fact about the papers; 2 usage or input error; 130 or 143\n"
        "when SIGINT or SIGTERM ended it: the figures that were measured are stored, and --resume goes on.\n\n"
        "Example: plumb reproduce yakowitz 'sequences/one-*'");
    return [options](const Catalogue&) { return reproduce(*options); };
}

std::string reason(const CLI::ParseError& error) {
    const std::string_view what = error.what();
    if (dynamic_cast<const CLI::ExcludesError*>(&error) && what.find("--resume") != std::string_view::npos)
        return "a resumed run keeps the patterns, seed, size and shard that it began with";
    if (dynamic_cast<const CLI::RequiresError*>(&error) && what.starts_with("--shard requires"))
        return "all shards of a run must have the same seed";
    return {};
}

}  // namespace

Verb reproduce() {
    return {"reproduce", "Lay what papers promise against what is measured: one page", add, reason};
}

}  // namespace plumb::cli::verbs
