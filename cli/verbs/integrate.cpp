#include <CLI/CLI.hpp>

#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/values.h"
#include "cli/verb.h"
#include "core/error.h"
#include "core/error_target.h"
#include "core/file.h"
#include "reports/run/html.h"
#include "reports/run/json.h"
#include "studies/own/integrate.h"

namespace plumb::cli::verbs {
namespace {

struct Options : own::IntegralTask {
    std::optional<std::uint64_t> seed;
    int threads = 0;
    std::string json, report = "out/integrate.html";
};

int integrate(Options options) {
    require_writable({options.json, options.report});
    Session session(options.seed, options.threads);
    session.run.patterns = fmt::format("{}", fmt::join(options.what, " "));
    std::vector<own::Answer> answers;
    options.progress = [&](double share, const Runs& seen) {
        const Estimate found = mean_of(seen);
        session.show(share, fmt::format("{:.6g} ± {:.2g} by {} runs of {} samples", found.value, found.standard_error,
                                        seen.estimates.size(), seen.n));
    };
    session.work([&] { answers = own::integrate(options, session.run.seed); });

    std::vector<Series> series;
    std::vector<reports::ListRow> rows;
    for (const own::Answer& answer : answers) {
        if (answer.series) series.push_back(*answer.series);
        rows.push_back(row_of(answer));
    }
    if (!options.json.empty()) write_output(options.json, reports::integration_json(session.run, rows, series));
    const bool page = !series.empty() && !options.report.empty();
    if (page) write_output(options.report, reports::converge_report_html(session.run, series));
    for (const own::Answer& answer : answers) fmt::print("{}", text_of(answer));
    if (page) fmt::print("report: {}\n", options.report);
    return std::ranges::all_of(answers, &own::Answer::target_met) ? 0 : 3;
}

void add_work(CLI::App& verb, own::IntegralTask& task) {
    CLI::Option* n =
        add_count(verb, "--n", task.n, 1, std::uint64_t{1} << 32, "samples in each run")->default_str("1024");
    add_parsed(verb, "--error", task.error, parse_error_target,
               "instead of --n: double n until the standard error is at most this, 1e-3 or 1%")
        ->excludes(n);
    add_count(verb, "--replicates", task.replicates, 16, 1'000'000, "independent runs, whose spread gives the error");
    add_count(verb, "--max-evaluations", task.max_evaluations, 1, std::uint64_t{1} << 48,
              "evaluations of the integrand at which --error gives up");
    add_count(verb, "--batches", task.batches, 2, 1'000'000, "cut a file of independent samples into this many sets");
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    verb.add_option("what", options->what,

                    "a formula of x (and y), @id of a shipped integrand, an image, or files of samples x[,y],f "
                    "(.csv, .tsv, .txt, .dat; - for standard input)")
        ->required();
    verb.add_option("--method", options->method,
                    "see plumb list estimators [sobol-owen]; for samples: voronoi [default], torus, reweighted (1D), "
                    "stratified-reweighted (1D), voronoi-reweighted (2D), independent");
    add_work(verb, *options);
    add_domain(verb, options->domain);
    verb.add_option("--channel", options->channel,
                    "the channel of an image, or luminance; all channels when not given");
    verb.add_option("--lookup", options->lookup,
                    "how an image is read between its pixels: nearest [default] or bilinear")
        ->check(CLI::IsMember({"nearest", "bilinear"}));
    add_seed_and_threads(verb, options->seed, options->threads);
    verb.add_option("--json", options->json, "write the answers as JSON to this file");
    verb.add_option("--report", options->report, "the page with the convergence plot; '' for none")
        ->capture_default_str();
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
