#include <CLI/CLI.hpp>

#include "cli/answer.h"
#include "cli/common_options.h"
#include "cli/integrate_samples.h"
#include "cli/session.h"
#include "cli/user_integrand.h"
#include "cli/values.h"
#include "cli/verb.h"
#include "core/error.h"
#include "core/error_target.h"

namespace plumb::cli::verbs {
namespace {

struct Options : IntegralTask {
    std::optional<std::uint64_t> seed;
    int threads = 0;
    std::string json, report = "out/integrate.html";
};

constexpr const char* default_method = "sobol-owen";
constexpr std::uint64_t default_n = 1024;

template <int D>
const Estimator<D>& method_for(const UserIntegrand<D>& f, const IntegralTask& task) {
    constexpr int other = 3 - D;
    const std::string id = task.method.value_or(default_method);
    const auto named = [&](const auto& estimator) { return estimator.id == id; };
    if (std::ranges::none_of(estimators<D>(), named) && std::ranges::any_of(estimators<other>(), named))
        throw Error(fmt::format("method '{}' is for {}D integrands, {} is {}D; see plumb list estimators", id, other,
                                f.name, D));
    return find_estimator<D>(id);
}

/// N/64, N/32 … N: what the plot shows for a fixed n.
std::vector<std::uint64_t> counts_up_to(std::uint64_t n) {
    std::vector<std::uint64_t> counts;
    for (int halvings = 6; halvings >= 0; --halvings)
        if (const std::uint64_t m = n >> halvings; m >= std::min<std::uint64_t>(n, 4)) counts.push_back(m);
    return counts;
}

template <int D>
Answer integrate(const UserIntegrand<D>& f, const IntegralTask& task, std::uint64_t seed) {
    const Estimator<D>& method = method_for(f, task);
    const IndependentRun run = [&](std::uint64_t n, RandomStream& random) {
        const Function<D> own = f.value;
        return method.run(own, n, random);
    };
    Answer answer{
        .integrand = f.name, .method = method.id, .runs = method.randomised ? task.replicates : 1, .exact = f.exact};
    const auto runs_at = [&](std::uint64_t n, std::string_view purpose) {
        return independent_runs(run, n, answer.runs, seed, purpose);
    };
    std::vector<Runs> sets;
    if (task.error) {
        if (!method.randomised)
            throw Error(
                fmt::format("--error: method '{}' is deterministic, so runs cannot tell its error; accepted are "
                            "randomised ones such as stratified, sobol-owen, torus-tent",
                            method.id));
        Search search = search_sample_count(run, *task.error, answer.runs, task.max_evaluations, seed);
        sets = std::move(search.looks);
        answer.all_evaluations = mean_of(sets.back()).evaluations;  // the last look makes room for the answer
        sets.back() = runs_at(sets.back().n, "answer");
    } else if (answer.exact || method.randomised) {
        for (const std::uint64_t n : counts_up_to(task.n.value_or(default_n)))
            sets.push_back(runs_at(n, n == task.n.value_or(default_n) ? "answer" : "look"));
    } else {
        sets.push_back(runs_at(task.n.value_or(default_n), "answer"));
    }

    answer.n = sets.back().n;
    answer.estimate = mean_of(sets.back());
    for (const Runs& runs : sets) answer.all_evaluations += mean_of(runs).evaluations;
    if (task.error) {
        answer.target = task.error->absolute(answer.estimate.value);
        answer.target_met = task.error->met_by(answer.estimate) && !skewed(sets.back());
        answer.known.push_back("n was chosen by looking; value and error are from fresh runs at that n");
    }
    if (skewed(sets.back()))
        answer.known.push_back("the runs are skewed, as with spikes or infinite variance: the error is too small");
    if (!method.randomised)
        answer.known.push_back("the method is deterministic: its error is unknown, since every run is the same");
    else if (std::isinf(answer.estimate.standard_error))
        answer.known.push_back("all runs gave the same value: no spread seen says nothing about the error");
    else if (!method.unbiased)
        answer.known.push_back("the method is biased: the error is its spread and leaves the bias out");
    if (answer.exact || method.randomised) {
        answer.series = series_of(sets, answer);
        if (f.shipped && method.expected_slope) answer.series->expected_slope = method.expected_slope(*f.shipped);
    }
    return answer;
}

int integrate(const Options& options) {
    require_writable({options.json, options.report});
    Session session(options.seed, options.threads);
    session.run.patterns = fmt::format("{}", fmt::join(options.what, " "));
    std::vector<Answer> answers;
    session.work([&] {
        if (kind_of(options.what.front()) == InputKind::samples) {
            answers.push_back(integrate_samples(options));
            return;
        }
        std::visit(
            [&](const auto& list) {
                for (const auto& f : list) answers.push_back(integrate(f, options, session.run.seed));
            },
            read_integrands(options));
    });
    return tell(answers, session.run, options.json, options.report);
}

void add_work(CLI::App& verb, IntegralTask& task) {
    CLI::Option* n = verb.add_option("--n", task.n, "samples a run [1024]");
    n->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 32));
    add_parsed(verb, "--error", task.error, parse_error_target,
               "instead of --n: double n until the standard error is at most this, 1e-3 or 1%")
        ->excludes(n);
    verb.add_option("--replicates", task.replicates, "independent runs, whose spread gives the error")
        ->check(CLI::Range(16, 1'000'000))
        ->capture_default_str();
    verb.add_option("--max-evaluations", task.max_evaluations, "where --error gives up")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 48))
        ->capture_default_str();
    verb.add_option("--batches", task.batches, "cut a file of independent samples into this many sets")
        ->check(CLI::Range(2, 1'000'000));
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    verb.add_option("what", options->what,
                    "a formula of x (and y), @id of a shipped integrand, an image, or CSV files of samples x[,y],f")
        ->required();
    verb.add_option("--method", options->method,
                    "see plumb list estimators [sobol-owen]; for samples: voronoi [default], torus, reweighted (1D), "
                    "stratified-reweighted (1D), voronoi-reweighted (2D), independent");
    add_work(verb, *options);
    add_domain(verb, options->domain);
    verb.add_option("--channel", options->channel, "of an image, or luminance; all when not given");
    verb.add_option("--lookup", options->lookup, "in an image: nearest [default] or bilinear")
        ->check(CLI::IsMember({"nearest", "bilinear"}));
    add_seed_and_threads(verb, options->seed, options->threads);
    verb.add_option("--json", options->json, "write the answers as JSON to this file");
    verb.add_option("--report", options->report, "the page with the convergence plot")->capture_default_str();
    verb.footer(
        "Exit code: 0, or 3 when the target was missed, 2 usage or input error.\n\n"
        "Example: plumb integrate 'exp(x)*sin(3*y)' --method torus-tent --error 0.1%");
    return [options](const Catalogue&) { return integrate(*options); };
}

}  // namespace

Verb integrate() {
    return {"integrate", "Integrate a formula, an image or samples of your own", add};
}

}  // namespace plumb::cli::verbs
