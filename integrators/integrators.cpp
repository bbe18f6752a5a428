#include "integrators/integrators.h"

#include <fmt/format.h>

#include "core/error.h"
#include "integrators/estimators/aov.h"
#include "integrators/estimators/direct.h"
#include "integrators/estimators/one_length.h"

namespace plumb {

namespace {

template <TechniqueCounts counts>
std::unique_ptr<PathEstimator> direct(const PathLimits&) {
    return std::make_unique<Direct>(counts);
}

}  // namespace

const std::vector<NamedIntegrator>& integrators() {
    static const std::vector<NamedIntegrator> all{
        {"aov", "what is seen first: albedo, with normal and depth", "ours, integrators/estimators/aov.h",
         [](const PathLimits&) -> std::unique_ptr<PathEstimator> { return std::make_unique<Aov>(); }},
        {"bdpt", "all light: subpaths from the sensor and from a light, connected in all ways", "Veach & Guibas 1994",
         [](const PathLimits& limits) -> std::unique_ptr<PathEstimator> { return std::make_unique<Bdpt>(limits); }},
        {"direct", "direct light by samples of emitters and of BSDFs, power heuristic", "Veach & Guibas 1995",
         direct<one_of_each>},
        {"direct-bsdf", "direct light by samples of BSDFs alone", "Veach & Guibas 1995", direct<bsdf_alone>},
        {"direct-emitters", "direct light by samples of emitters alone", "Veach & Guibas 1995", direct<emitters_alone>},
        {"light", "light traced from its sources, each vertex connected to the lens", "Arvo 1986",
         [](const PathLimits& limits) -> std::unique_ptr<PathEstimator> {
             return std::make_unique<LightTracer>(limits);
         }},
        {"path", "all light: emitter and BSDF samples at each vertex of a path from the sensor", "Kajiya 1986",
         [](const PathLimits& limits) -> std::unique_ptr<PathEstimator> {
             return std::make_unique<PathTracer>(limits);
         }},
    };
    return all;
}

const NamedIntegrator& find_integrator(const std::string& id) {
    std::vector<std::string> known;
    for (const NamedIntegrator& integrator : integrators()) {
        if (integrator.id == id) return integrator;
        known.push_back(integrator.id);
    }
    throw unknown_name("integrator", id, known);
}

std::unique_ptr<PathEstimator> make_integrator(const std::string& id, PathLimits limits) {
    const NamedIntegrator& named = find_integrator(id);
    if (limits.strategy && id != "bdpt")
        throw Error(fmt::format("a strategy of the integrator '{}'; accepted is bdpt", id));
    if (id.starts_with("direct") && limits.max_edges >= 0 && limits.max_edges != 2)
        throw Error(fmt::format("paths of up to {} edges by the integrator '{}', whose have 2; accepted are 2 and -1",
                                limits.max_edges, id));
    if (limits.length > 0 && limits.max_edges < 0) limits.max_edges = limits.length;  // no longer path is asked for
    auto estimator = named.make(limits);
    if (limits.length == 0) return estimator;
    return std::make_unique<OneLength>(std::move(estimator), limits.length);
}

}  // namespace plumb
