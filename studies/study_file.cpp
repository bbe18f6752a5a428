#include "studies/study_file.h"

#include <filesystem>

#include "core/error.h"
#include "core/sample_counts.h"
#include "estimators/replicates/batches.h"
#include "estimators/reweighting/step_density_estimators.h"
#include "studies/headline_file.h"
#include "studies/scene_series.h"
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

// ---- the study's own estimators

template <int D>
void add_batches(Study& study, const Section& section, const std::string& id, const std::string& of) {
    if (!knows_estimator<D>(study, of)) return;
    const Estimator<D> estimator = find_estimator<D>(study, of);
    own_estimators<D>(study).push_back(section.has("size")
                                           ? in_batches_of(id, estimator, section.count("size", 1, most_samples))
                                           : batches_sharing(id, estimator, section.count("total", 1, most_samples)));
}

void read_batches(Study& study, const Section& section, const std::string& id) {
    const std::string of = section.text("of");
    if (section.has("size") == section.has("total")) section.fail("method", "batches need either size or total");
    if (!knows_estimator<1>(study, of) && !knows_estimator<2>(study, of))
        section.read("of", [&](const auto&) { return find_estimator<1>(study, of).id; });
    add_batches<1>(study, section, id, of);
    add_batches<2>(study, section, id, of);
}

StepDensity read_steps(const Section& section) {
    const std::vector<double> masses = section.numbers("masses");
    return section.read(section.has("edges") ? "edges" : "masses", [&](const auto&) {
        return section.has("edges") ? StepDensity(section.numbers("edges"), masses) : StepDensity::equal_pieces(masses);
    });
}

using StepEstimator = Estimator<1> (*)(std::string, StepDensity);
const std::vector<std::pair<std::string, StepEstimator>> step_methods = {
    {"step-importance", step_importance_estimator},
    {"step-strata", step_strata_estimator},
    {"step-reweighted", step_reweighted_estimator},
};

void read_estimator(Study& study, const toml::table& table, const std::string& file) {
    const std::vector<std::string> for_batches = {"id", "method", "of", "size", "total"},
                                   for_steps = {"id", "method", "masses", "edges"};
    const bool batches = table["method"].value_exact<std::string>() == "batches";
    const Section section(table, "estimator", file, batches ? for_batches : for_steps);
    const std::string id = section.text("id"), method = section.text("method");
    if (knows_estimator<1>(study, id) || knows_estimator<2>(study, id))
        section.fail("id", fmt::format("'{}' is the name of another estimator", id));
    if (batches) return read_batches(study, section, id);
    std::vector<std::string> known = {"batches"};
    for (const auto& [name, make] : step_methods) {
        if (name == method) return study.estimators_1d.push_back(make(id, read_steps(section)));
        known.push_back(name);
    }
    section.fail("method", unknown_name("method", method, known).what());
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

void check_names(const Study& study, const FigurePlan& plan, const Section& section) {
    for (const std::string& id : plan.integrands) {
        if (knows_integrand<1>(id)) {
            check_estimators(study, plan, section, find_integrand<1>(id));
        } else if (knows_integrand<2>(id)) {
            check_estimators(study, plan, section, find_integrand<2>(id));
        } else if (names_scene(id)) {
            section.read("estimators", [&](const auto&) { return check_scene_methods(plan.estimators), 0; });
            if (plan.budget.unit == Budget::Unit::evaluations)
                section.fail("evaluations", fmt::format("of the scene '{}'; n is accepted", id));
        } else {
            std::vector<std::string> known;
            for (const auto& f : integrands<1>()) known.push_back(f.id);
            for (const auto& f : integrands<2>()) known.push_back(f.id);
            section.fail("integrands", unknown_name("integrand", id, known).what());
        }
    }
}

void check_id(const Study& study, const std::string& id, const Section& section) {
    const std::string_view accepted = "abcdefghijklmnopqrstuvwxyz0123456789-";
    if (id.empty() || id.find_first_not_of(accepted) != std::string::npos)
        section.fail("id", fmt::format("'{}' found; lower-case letters, digits and hyphens are accepted", id));
    for (const FigurePlan& other : study.figures)
        if (other.about.id == id) section.fail("id", fmt::format("'{}' is the id of an earlier figure", id));
}

void read_figure(Study& study, FigurePlan plan, const toml::table& table, const std::string& file) {
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
    check_names(study, plan, section);
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
    for (const toml::table* figure : top.tables("figure")) read_figure(study, defaults, *figure, file);
    for (const toml::table* headline : top.tables("headline"))
        study.headlines.push_back(read_headline(study, *headline, file));
    if (study.figures.empty()) throw Error(fmt::format("{}: no figure; at least one [[figure]] is needed", file));
    return study;
}

}  // namespace plumb
