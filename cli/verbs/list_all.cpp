#include <CLI/CLI.hpp>

#include "analytic/integrand.h"
#include "cli/verb.h"
#include "cli/verbs/lists.h"
#include "estimators/estimator.h"
#include "integrators/drivers/drivers.h"
#include "integrators/drivers/sampler.h"
#include "integrators/integrators.h"
#include "scenes/mitsuba/plugins.h"
#include "scenes/shipped/shipped.h"

namespace plumb::cli::verbs {
namespace {

template <int D>
void append_integrands(std::vector<reports::ListRow>& rows) {
    for (const Integrand<D>& f : integrands<D>())
        rows.push_back({{"id", f.id},
                        {"dimension", std::uint64_t{D}},
                        {"formula", f.formula},
                        {"integral", f.integral},
                        {"variance", f.variance_value()},
                        {"smoothness", to_string(f.smoothness)},
                        {"periodic_smoothness", to_string(f.periodic_smoothness)},
                        {"source", f.source},
                        {"derivation", f.derivation}});
}

template <int D>
void append_estimators(std::vector<reports::ListRow>& rows) {
    for (const Estimator<D>& e : estimators<D>())
        rows.push_back({{"id", e.id},
                        {"dimension", std::uint64_t{D}},
                        {"unbiased", std::string(e.unbiased ? "yes" : "no")},
                        {"summary", e.summary},
                        {"source", e.source}});
}

// name=default (accepted), of each.
std::string text_of(const std::vector<Parameter>& parameters) {
    std::string all;
    for (const Parameter& one : parameters)
        all += fmt::format("{}{}={} ({}): {}", all.empty() ? "" : "; ", one.name, usual_of(one), accepted_by(one),
                           one.summary);
    return all;
}

// Of what takes parameters.
template <class Named>
std::vector<reports::ListRow> method_rows(const std::vector<Named>& list) {
    std::vector<reports::ListRow> rows;
    for (const Named& one : list)
        rows.push_back({{"id", one.id},
                        {"summary", one.summary},
                        {"parameters", text_of(one.parameters)},
                        {"source", one.source}});
    return rows;
}

std::vector<reports::ListRow> sampler_rows() {
    std::vector<reports::ListRow> rows;
    for (const PointSet<2>& set : samplers())
        rows.push_back({{"id", set.id}, {"summary", set.summary}, {"source", set.source}});
    return rows;
}

std::vector<reports::ListRow> scene_rows() {
    std::vector<reports::ListRow> rows;
    for (const ShippedScene& scene : shipped_scenes())
        rows.push_back({{"id", scene.name}, {"question", scene.question}, {"file", scene.file.string()}});
    return rows;
}

std::vector<reports::ListRow> plugin_rows(std::string_view kind) {
    std::vector<reports::ListRow> rows;
    for (const Plugin& plugin : known_plugins())
        if (plugin.kind == kind) rows.push_back({{"id", plugin.name}, {"summary", plugin.summary}});
    return rows;
}

template <auto append_1d, auto append_2d>
std::vector<reports::ListRow> both_dimensions() {
    std::vector<reports::ListRow> rows;
    append_1d(rows);
    append_2d(rows);
    return rows;
}

Lists shipped_lists(const Catalogue& catalogue) {
    Lists lists = catalogue_lists(catalogue);
    lists["integrands"] = both_dimensions<append_integrands<1>, append_integrands<2>>;
    lists["estimators"] = both_dimensions<append_estimators<1>, append_estimators<2>>;
    lists["integrators"] = [] { return method_rows(integrators()); };
    lists["drivers"] = [] { return method_rows(drivers()); };
    lists["samplers"] = sampler_rows;
    lists["scenes"] = scene_rows;
    for (const char* kind : {"bsdf", "emitter", "sensor", "shape", "texture"})
        lists[std::string(kind) + "s"] = [kind] { return plugin_rows(kind); };
    return lists;
}

}  // namespace

Verb list_all() {
    return {"list", "List what Plumb knows", [](CLI::App& verb) {
                verb.footer("Example: plumb list integrands --json");
                return add_list(
                    verb,
                    "one of claims, mutants, integrands, estimators, integrators, drivers, samplers, scenes, "
                    "bsdfs, emitters, sensors, shapes or textures",
                    shipped_lists);
            }};
}

}  // namespace plumb::cli::verbs
