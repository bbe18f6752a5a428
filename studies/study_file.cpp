#include "studies/study_file.h"

#include <filesystem>

#include "analytic/any_integrand.h"
#include "core/error.h"
#include "core/sample_counts.h"
#include "studies/estimator_file.h"
#include "studies/headline_file.h"
#include "studies/section.h"

namespace plumb {
namespace {

// ---- budgets, metrics, axes, guides: may stand at the top as defaults, and in a figure

const std::vector<std::string> measure_keys = {"n", "evaluations", "replicates", "reference", "metrics", "x", "slopes"};

std::vector<std::uint64_t> counts(const Section& section, const char* key) {
    return section.read(key, [&](const toml::node& node) {
        if (const auto range = node.value_exact<std::string>()) return parse_sample_counts(*range);
        const auto one_by_one = section.list<std::int64_t>(key, "a list of counts or a range such as \"16..4096\"",
                                                           [](std::int64_t n) { return std::to_string(n); });
        return parse_sample_counts(fmt::format("{}", fmt::join(one_by_one, ",")));
    });
}

void read_measure(const Section& section, FigurePlan& plan) {
    if (section.has("n") && section.has("evaluations"))
        section.fail("evaluations", "stands beside n; one of the two is accepted");
    if (section.has("n")) plan.budget = {Budget::Unit::samples, counts(section, "n")};
    if (section.has("evaluations")) plan.budget = {Budget::Unit::evaluations, counts(section, "evaluations")};
    if (section.has("replicates")) plan.replicates = section.count("replicates", 2, 100'000'000);
    if (section.has("metrics"))
        plan.about.metrics = section.list<std::string>("metrics", "a metric", reports::metric_from);
    if (section.has("x"))
        plan.about.x = section.read("x", [&](const auto&) { return reports::work_from(section.text("x")); });
    if (section.has("reference")) plan.reference = section.text("reference");
    if (section.has("slopes")) plan.about.slopes = section.numbers("slopes");
}

// ---- figures

template <int D>
void check_estimators(const Study& study, const FigurePlan& plan, const Section& section, const Integrand<D>& f) {
    section.read("estimators", [&](const auto&) {
        for (const std::string& id : plan.estimators) find_estimator<D>(study, id);
        return 0;
    });
    if (std::abs(f.integral_value()) > 1e-12 * f.root_mean_square()) return;
    for (const reports::Metric metric : plan.about.metrics)
        if (reports::entry(metric).by_truth)
            section.fail("metrics", fmt::format("{} of '{}', whose integral is 0", to_string(metric), f.id));
}

void check_methods(const Study& study, const FigurePlan& plan, const Section& section, const ScenePart& part) {
    section.read("estimators", [&](const auto&) {
        for (const std::string& id : plan.estimators) find_scene_method(study, id);
        return 0;
    });
    if (plan.budget.unit == Budget::Unit::evaluations)
        section.fail("evaluations", fmt::format("of the scene '{}'; n is accepted", part.id));
}

/// Whatever figures are drawn of: scenes are loaded here.
void read_subjects(Study& study, const FigurePlan& plan, const Section& section, LoadedScenes& scenes) {
    for (const std::string& id : plan.integrands) {
        if (const auto integrand = known_integrand(id)) {
            std::visit([&](const auto* f) { check_estimators(study, plan, section, *f); }, *integrand);
            continue;
        }
        const auto part = section.read("integrands", [&](const auto&) { return scene_part(id, scenes); });
        if (!part) section.read("integrands", [&](const auto&) { return find_any_integrand(id); });
        check_methods(study, plan, section, *part);
        if (std::ranges::find(study.scene_parts, id, &ScenePart::id) == study.scene_parts.end())
            study.scene_parts.push_back(*part);
    }
}

void check_id(const Study& study, const std::string& id, const Section& section) {
    const std::string_view accepted = "abcdefghijklmnopqrstuvwxyz0123456789-";
    if (id.empty() || id.find_first_not_of(accepted) != std::string::npos)
        section.fail("id", fmt::format("'{}' found; lower-case letters, digits and hyphens are accepted", id));
    for (const FigurePlan& other : study.figures)
        if (other.about.id == id) section.fail("id", fmt::format("'{}' is the id of an earlier figure", id));
}

void read_figure(Study& study, FigurePlan plan, const toml::table& table, const std::string& file,
                 LoadedScenes& scenes) {
    std::vector<std::string> accepted = {"id", "title", "text", "source_says", "estimators", "integrands", "x_label"};
    accepted.insert(accepted.end(), measure_keys.begin(), measure_keys.end());
    const Section section(table, "figure", file, accepted);
    read_measure(section, plan);
    plan.about.id = section.text("id");
    check_id(study, plan.about.id, section);
    plan.about.title = section.text("title", plan.about.id);
    plan.about.text = section.text("text", "");
    plan.about.source_says = section.text("source_says", "");
    plan.about.x_label = section.text("x_label", "");
    plan.estimators = section.names("estimators");
    plan.integrands = section.names("integrands");
    if (plan.budget.counts.empty()) section.fail("n", "is missing; it, or evaluations, may also stand at the top");
    read_subjects(study, plan, section, scenes);
    study.figures.push_back(std::move(plan));
}

toml::table parsed(std::string_view text, const std::string& file) {
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw Error(fmt::format("{}:{}: not TOML: {}", file, error.source().begin.line, error.description()));
    }
}

}  // namespace

Study parse_study(std::string_view text, const std::string& file) {
    const toml::table table = parsed(text, file);
    std::vector<std::string> accepted = {"title", "text", "source", "seed", "estimator", "figure", "headline"};
    accepted.insert(accepted.end(), measure_keys.begin(), measure_keys.end());
    const Section top(table, "", file, accepted);
    Study study;
    study.about = {.name = std::filesystem::path(file).stem().string(),
                   .title = top.text("title"),
                   .text = top.text("text", ""),
                   .source = top.text("source", "")};
    if (top.has("seed")) study.seed = top.count("seed", 0, std::uint64_t{1} << 53);
    FigurePlan defaults;
    read_measure(top, defaults);
    for (const toml::table* estimator : top.tables("estimator")) read_estimator(study, *estimator, file);
    LoadedScenes scenes({.lenient = true});
    for (const toml::table* figure : top.tables("figure")) read_figure(study, defaults, *figure, file, scenes);
    for (const toml::table* headline : top.tables("headline"))
        study.headlines.push_back(read_headline(study, *headline, file));
    if (study.figures.empty()) throw Error(fmt::format("{}: no figure; at least one [[figure]] is needed", file));
    return study;
}

}  // namespace plumb
