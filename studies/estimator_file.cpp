#include "studies/estimator_file.h"

#include "core/named.h"
#include "core/sample_counts.h"
#include "estimators/replicates/batches.h"
#include "estimators/reweighting/step_density_estimators.h"
#include "integrators/drivers/sampler.h"
#include "integrators/integrators.h"

namespace plumb {
namespace {

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

template <Estimator<1> (*make)(std::string, StepDensity)>
void read_step_estimator(Study& study, const Section& section, const std::string& id) {
    study.estimators_1d.push_back(make(id, read_steps(section)));
}

/// A scalar as one types it behind `-P name=`.
std::string parameter_text(const toml::key& name, const toml::node& node) {
    if (const auto flag = node.value_exact<bool>()) return *flag ? "yes" : "no";
    if (const auto text = node.value_exact<std::string>()) return *text;
    if (const auto number = node.value_exact<std::int64_t>()) return fmt::format("{}", *number);
    if (const auto number = node.value_exact<double>()) return fmt::format("{}", *number);
    throw Error(fmt::format("{} is {}; a number, a string, true or false is accepted", name.str(), found(node)));
}

ParameterTexts read_parameters(const toml::node& node) {
    if (!node.is_table())
        throw Error(fmt::format("{} found; a table is accepted, such as {{ roulette-start = 3 }}", found(node)));
    ParameterTexts texts;
    for (const auto& [name, value] : *node.as_table())
        texts.emplace(std::string(name.str()), parameter_text(name, value));
    return texts;
}

void read_render(Study& study, const Section& section, const std::string& id) {
    RenderMethod render;
    render.integrator = section.text("integrator");
    section.read("integrator", [&](const auto&) { return find_integrator(render.integrator).id; });
    if (section.has("sampler"))
        render.sampler = section.read("sampler", [&](const auto&) { return find_sampler(section.text("sampler")).id; });
    if (section.has("parameters"))
        render = section.read("parameters", [&](const toml::node& node) {
            render.parameters = read_parameters(node);
            return resolved(render);
        });
    study.scene_methods.push_back({id, resolved(render)});
}

/// A way to make an estimator: the keys that it takes besides id and method, and what adds it to the study.
struct Method {
    std::string id;
    std::vector<std::string> keys;
    void (*read)(Study& study, const Section& section, const std::string& id);
};

const std::vector<Method>& methods() {
    static const std::vector<Method> all = {
        {"batches", {"of", "size", "total"}, read_batches},
        {"render", {"integrator", "sampler", "parameters"}, read_render},
        {"step-importance", {"masses", "edges"}, read_step_estimator<step_importance_estimator>},
        {"step-strata", {"masses", "edges"}, read_step_estimator<step_strata_estimator>},
        {"step-reweighted", {"masses", "edges"}, read_step_estimator<step_reweighted_estimator>},
    };
    return all;
}

const Method& method_of(const toml::table& table, const std::string& file) {
    std::vector<std::string> keys = {"id", "method"};
    for (const Method& method : methods()) keys.insert(keys.end(), method.keys.begin(), method.keys.end());
    const Section section(table, "estimator", file, keys);
    return *section.read("method",
                         [&](const auto&) { return &find_named(methods(), section.text("method"), "method"); });
}

bool knows(const Study& study, const std::string& id) {
    return knows_estimator<1>(study, id) || knows_estimator<2>(study, id) ||
           std::ranges::find(study.scene_methods, id, &SceneMethod::id) != study.scene_methods.end();
}

}  // namespace

void read_estimator(Study& study, const toml::table& table, const std::string& file) {
    const Method& method = method_of(table, file);
    std::vector<std::string> keys = {"id", "method"};
    keys.insert(keys.end(), method.keys.begin(), method.keys.end());
    const Section section(table, "estimator", file, keys);
    const std::string id = section.text("id");
    if (knows(study, id)) section.fail("id", fmt::format("'{}' is the name of another estimator", id));
    method.read(study, section, id);
}

}  // namespace plumb
