#include "cli/options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstring>
#include <filesystem>

#include "cli/option_adders.h"
#include "core/error.h"
#include "core/sample_counts.h"
#include "core/version.h"

namespace plumb::cli {
namespace {

const CLI::Validator whole_number(
    [](const std::string& text) -> std::string {
        std::uint64_t value = 0;
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = failure == std::errc() && end == text.data() + text.size();
        return whole ? "" : fmt::format("'{}' is not a whole number from 0 to 2^64 - 1", text);
    },
    "from 0 to 2^64 - 1");

}  // namespace

void add_seed(CLI::App* verb, std::optional<std::uint64_t>& seed) {
    verb->add_option("--seed", seed, "the run's random seed; a new one when not given, recorded either way")
        ->check(whole_number);
}

void add_seed_and_threads(CLI::App* verb, std::optional<std::uint64_t>& seed, int& threads) {
    add_seed(verb, seed);
    verb->add_option("--threads", threads, "worker threads; the results do not depend on them")
        ->check(CLI::Range(1, 4096));
}

namespace {

void add_outputs(CLI::App* verb, Outputs& outputs) {
    verb->add_option("--json", outputs.json, "write verdicts as JSON to this file");
    verb->add_option("--junit", outputs.junit, "write verdicts as JUnit XML, for CI servers, to this file");
    verb->add_option("--report", outputs.report, "the HTML report; '' for none")->capture_default_str();
    verb->add_option("--store", outputs.store, "the SQLite store that the run is added to")->capture_default_str();
}

void add_sampler(CLI::App* verify, SamplerOptions& options) {
    CLI::Option* sampler = verify->add_option("--sampler", options.command,
                                              "judge a sampler in another process instead: a command that prints {n} "
                                              "samples, one a line, from the seed {seed}");
    CLI::Option* density =
        verify->add_option("--density", options.density,
                           "the sampler's density: a CSV file, or uniform, linear:A,B, exponential:RATE, uniform-2d, "
                           "bilinear:A,B,C,D");
    sampler->needs(density);
    for (const char* other : {"patterns", "--full", "--shard", "--resume"})
        sampler->excludes(verify->get_option(other));
    density->needs(sampler);
    verify->add_option("--delta", options.delta, "the density error (phi) that `holds` excludes")
        ->check(probability())
        ->needs(sampler)
        ->capture_default_str();
    verify
        ->add_option_function<std::string>(
            "--sampler-timeout", [&](const std::string& text) { options.timeout = parse_duration(text); },
            "when a sampler that is not done is stopped; 60s when not given")
        ->check(checked(parse_duration))
        ->needs(sampler);
}

void add_verify(CLI::App& app, VerifyOptions& options) {
    CLI::App* verb = app.add_subcommand("verify", "Judge claims and their mutants; write a report");
    CLI::Option* patterns =
        verb->add_option("patterns", options.patterns, "claims to judge, e.g. 'reweighting/*'; all when none is given");
    CLI::Option* full =
        verb->add_flag("--full", options.full, "the full size of every claim (about 20 times the work)");
    CLI::Option* alpha = verb->add_option("--alpha", options.alpha, "false-alarm budget of the whole run")
                             ->check(probability())
                             ->capture_default_str();
    verb->add_option_function<std::string>(
            "--time-limit", [&](const std::string& text) { options.time_limit = parse_duration(text); },
            "stop drawing after this long, e.g. 60s: what is open then is undecided")
        ->check(checked(parse_duration));
    add_seed_and_threads(verb, options.seed, options.threads);
    CLI::Option* seed = verb->get_option("--seed");
    CLI::Option* shard = verb->add_option_function<std::string>(
        "--shard", [&](const std::string& text) { options.shard = parse_shard(text); },
        "judge the i-th of n parts, i/n; plumb merge joins them. Needs --seed");
    shard->check(checked(parse_shard))->needs(seed);
    CLI::Option* resume =
        verb->add_flag("--resume", options.resume, "go on with the store's newest unfinished run, with its settings");
    for (CLI::Option* setting : {patterns, full, alpha, seed, shard}) resume->excludes(setting);
    add_outputs(verb, options);
    add_sampler(verb, options.sampler);
    verb->footer(
        "Exit code: 0 every claim holds and every mutant is refuted, 1 a claim refuted or a mutant alive,\n"
        "2 usage or input error, 3 something undecided; 130 or 143 when SIGINT or SIGTERM ended it: what was judged\n"
        "is stored, and --resume goes on.\n\n"
        "Example: plumb verify 'reweighting/*' 'points/*' --json verdicts.json");
}

void add_list(CLI::App& app, ListOptions& options, VerbSet verbs) {
    const bool shipped = verbs == VerbSet::shipped;
    CLI::App* verb = app.add_subcommand("list", "List what Plumb knows");
    verb->add_option("what", options.what,
                     shipped ? "claims, mutants, integrands, estimators, integrators, scenes, bsdfs, emitters, "
                               "sensors, shapes or textures"
                             : "claims or mutants")
        ->required();
    verb->add_flag("--json", options.json, "as JSON, to standard output");
    verb->footer(shipped ? "Example: plumb list integrands --json" : "Example: list claims --json");
}

void add_converge(CLI::App& app, ConvergeOptions& options, std::string& counts) {
    CLI::App* verb = app.add_subcommand("converge", "Measure error against samples, evaluations and seconds");
    CLI::Option* estimators = verb->add_option(
        "estimators", options.estimators,
        "e.g. independent torus-tent, or on scenes direct, direct+sobol; see plumb list estimators|integrators");
    CLI::Option* on = verb->add_option("--on", options.integrands,
                                       "integrands, e.g. exp, or scenes: SCENE, SCENE:x,y (a pixel), "
                                       "SCENE:x,y,width,height");
    CLI::Option* images =
        verb->add_option("--images", options.images,
                         "instead: the error of images that you have, 'out_{spp}_{seed}.exr'; {seconds} too, if known")
            ->excludes(estimators)
            ->excludes(on);
    verb->add_option("--reference", options.reference,
                     "the truth: an image, or auto for the cached one of a scene; measured when not given");
    add_cache(verb, options.cache);
    verb->add_option("--n", counts, "sample counts: first..last (doubling) or a list a,b,c")
        ->check(checked(parse_sample_counts))
        ->capture_default_str();
    verb->add_option("--replicates", options.replicates, "independent runs at each count")
        ->check(CLI::Range(2, 100'000'000))
        ->capture_default_str();
    add_seed_and_threads(verb, options.seed, options.threads);
    for (const char* other : {"--cache", "--n", "--replicates", "--seed"}) images->excludes(verb->get_option(other));
    verb->add_option("--json", options.json, "write the series as JSON to this file");
    verb->add_option("--report", options.report, "the page with the plots")->capture_default_str();
    verb->footer(
        "Examples: plumb converge independent torus-tent --on exp --n 16..4096\n"
        "          plumb converge direct direct+sobol --on cornell_box:64,64\n"
        "          plumb converge --images 'out_{spp}_{seed}.exr' --reference ref.exr");
}

void add_study(CLI::App& app, StudyOptions& options) {
    CLI::App* verb = app.add_subcommand("study", "Compare estimators as a file says: a page, CSV and SVG");
    verb->add_option("study", options.study, "a TOML file (docs/studies.md), or the name of a shipped study");
    verb->add_flag("--list", options.list, "list the shipped studies instead");
    verb->add_option("--replicates", options.replicates, "independent runs of each point, in place of the study's own")
        ->check(CLI::Range(2, 100'000'000));
    verb->add_option("--out", options.out, "the folder that the study is written to; out/study-NAME when not given");
    add_seed_and_threads(verb, options.seed, options.threads);
    verb->footer("Example: plumb study boundary");
}

void add_domain(CLI::App* verb, std::vector<double>& domain) {
    verb->add_option_function<std::string>(
            "--domain", [&](const std::string& text) { domain = parse_domain(text); },
            "both ends of each axis: x0,x1 or x0,x1,y0,y1; the unit interval or square when not given")
        ->check(checked(parse_domain));
}

void add_integrate(CLI::App& app, IntegrateOptions& options) {
    CLI::App* verb = app.add_subcommand("integrate", "Integrate a formula, an image or samples of your own");
    verb->add_option("what", options.what,
                     "a formula of x (and y), @id of a shipped integrand, an image, or CSV files of samples x[,y],f")
        ->required();
    verb->add_option("--method", options.method,
                     "see plumb list estimators [sobol-owen]; for samples: voronoi [default], torus, reweighted (1D), "
                     "stratified-reweighted (1D), voronoi-reweighted (2D), independent");
    CLI::Option* n = verb->add_option("--n", options.n, "samples a run [1024]");
    n->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 32));
    verb->add_option_function<std::string>(
            "--error", [&](const std::string& text) { options.error = parse_error_target(text); },
            "instead of --n: double n until the standard error is at most this, 1e-3 or 1%")
        ->check(checked(parse_error_target))
        ->excludes(n);
    verb->add_option("--replicates", options.replicates, "independent runs, whose spread gives the error")
        ->check(CLI::Range(16, 1'000'000))
        ->capture_default_str();
    verb->add_option("--max-evaluations", options.max_evaluations, "where --error gives up")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 48))
        ->capture_default_str();
    verb->add_option("--batches", options.batches, "cut a file of independent samples into this many sets")
        ->check(CLI::Range(2, 1'000'000));
    add_domain(verb, options.domain);
    verb->add_option("--channel", options.channel, "of an image, or luminance; all when not given");
    verb->add_option("--lookup", options.lookup, "in an image: nearest [default] or bilinear")
        ->check(CLI::IsMember({"nearest", "bilinear"}));
    add_seed_and_threads(verb, options.seed, options.threads);
    verb->add_option("--json", options.json, "write the answers as JSON to this file");
    verb->add_option("--report", options.report, "the page with the convergence plot")->capture_default_str();
    verb->footer(
        "Exit code: 0, or 3 when the target was missed, 2 usage or input error.\n\n"
        "Example: plumb integrate 'exp(x)*sin(3*y)' --method torus-tent --error 0.1%");
}

void add_weights(CLI::App& app, WeightsOptions& options) {
    CLI::App* verb = app.add_subcommand("weights", "Weigh your own points by their Voronoi cells");
    verb->add_option("points", options.points, "a CSV file with columns x or x,y")->required();
    verb->add_flag("--periodic", options.periodic, "on the torus: opposite ends are one place");
    add_domain(verb, options.domain);
    verb->add_option("-o,--output", options.out, "where the CSV goes; standard output when not given");
    verb->footer("Example: plumb weights points.csv --periodic -o weights.csv");
}

void add_report(CLI::App& app, ReportOptions& options) {
    CLI::App* verb = app.add_subcommand("report", "Rebuild the report of a stored run");
    verb->add_option("--run", options.run, "the run's number; the newest when not given");
    verb->add_option("--against", options.against, "another run: show what changed since");
    verb->add_flag("--list", options.list, "list the stored runs instead");
    verb->add_option("--store", options.store, "the SQLite store")->capture_default_str();
    verb->add_option("--report", options.report, "where the page goes")->capture_default_str();
    verb->footer("Example: plumb report --run 12 --against 11");
}

void add_merge(CLI::App& app, MergeOptions& options, VerbSet verbs) {
    CLI::App* verb = app.add_subcommand("merge", "Join the shards of a run into the run that they make up");
    verb->add_option("stores", options.stores, "the stores that the shards were verified with")->required();
    add_outputs(verb, options);
    std::string of_films;
    if (verbs == VerbSet::shipped) {
        CLI::Option* image = verb->add_option("-o,--output", options.image,
                                              "of parts of a film (plumb render --shard) instead: the image");
        for (const char* other : {"--json", "--junit", "--report", "--store"}) image->excludes(verb->get_option(other));
        of_films = "\n         plumb merge part-*.film -o picture.exr";
    }
    verb->footer(
        "Exit code: as of plumb verify. Merging twice changes nothing.\n\n"
        "Example: plumb merge shard-*.db --store out/results.db" +
        of_films);
}

// CLI11 says "The following argument was not expected": name it, and the nearest known one.
std::string complaint_of(const CLI::App& app, const CLI::ParseError& error, int argc, const char* const* argv) {
    const CLI::App* verb = &app;
    for (const CLI::App* sub : app.get_subcommands()) verb = sub;
    std::vector<std::string> verbs, options;
    for (const CLI::App* sub : app.get_subcommands(nullptr)) verbs.push_back(sub->get_name());
    for (const CLI::Option* option : verb->get_options())
        for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    if (verb == &app && argc > 1 && argv[1][0] != '-') return unknown_name("verb", argv[1], verbs).what();
    for (int i = 2; i < argc && std::string_view(argv[i]) != "--"; ++i)
        if (argv[i][0] == '-' && std::strchr("-.0123456789", argv[i][1]) == nullptr &&
            !verb->get_option_no_throw(std::string(argv[i]).substr(0, 2)))
            return fmt::format("unknown option '{}'; what begins with - but is no option goes last, after --", argv[i]);
    if (dynamic_cast<const CLI::ExtrasError*>(&error))
        for (int i = 1; i < argc; ++i) {
            const std::string typed = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
            if (typed.starts_with("--") && std::ranges::find(options, typed) == options.end())
                return unknown_name("option", typed, options).what();
        }
    if (dynamic_cast<const CLI::ExcludesError*>(&error) && verb->get_name() == "verify")
        return fmt::format("{}: a resumed run keeps the patterns, seed, alpha, size and shard that it began with",
                           error.what());
    if (dynamic_cast<const CLI::RequiresError*>(&error) && verb->get_name() == "verify")
        return fmt::format("{}: all shards of a run must have the same seed", error.what());
    return error.what();
}

}  // namespace

Options parse_options(int argc, const char* const* argv, VerbSet verbs) {
    const std::string name = std::filesystem::path(argv[0]).filename().string();
    CLI::App app("Plumb decides whether a Monte Carlo estimator is true.", name);
    app.set_version_flag("--version", std::string(version));
    app.require_subcommand(1);
    app.footer(name + " VERB --help explains a verb, with an example.");
    VerifyOptions verify;
    ListOptions list;
    ConvergeOptions converge;
    std::string counts = "16..4096";
    IntegrateOptions integrate;
    WeightsOptions weights;
    RenderOptions render;
    CompareOptions compare;
    ExplainOptions explain;
    ReferenceOptions reference;
    CheckOptions check;
    StudyOptions study;
    ReportOptions report;
    MergeOptions merge;
    add_verify(app, verify);
    add_list(app, list, verbs);
    if (verbs == VerbSet::shipped) {
        add_converge(app, converge, counts);
        add_render(app, render);
        add_explain(app, explain);
        add_reference(app, reference);
        add_compare(app, compare);
        add_check(app, check);
        add_integrate(app, integrate);
        add_weights(app, weights);
        add_study(app, study);
    }
    add_report(app, report);
    add_merge(app, merge, verbs);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& answer) {
        return Answered{app.exit(answer)};
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "{}: {}\n", name, complaint_of(app, error, argc, argv));
        return Answered{2};
    }
    converge.n = parse_sample_counts(counts);
    if (app.got_subcommand("verify")) return verify;
    if (app.got_subcommand("list")) return list;
    if (app.got_subcommand("report")) return report;
    if (app.got_subcommand("study")) return study;
    if (app.got_subcommand("render")) return render;
    if (app.got_subcommand("explain")) return explain;
    if (app.got_subcommand("reference")) return reference;
    if (app.got_subcommand("compare")) return compare;
    if (app.got_subcommand("check")) return check;
    if (app.got_subcommand("integrate")) return integrate;
    if (app.got_subcommand("weights")) return weights;
    if (app.got_subcommand("merge")) return merge;
    return converge;
}

}  // namespace plumb::cli
