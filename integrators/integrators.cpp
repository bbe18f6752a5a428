#include "integrators/integrators.h"

#include "integrators/aov.h"
#include "integrators/direct.h"

namespace plumb {

namespace {

template <LightTechniques techniques>
std::unique_ptr<PathEstimator> direct(const PathLimits&) {
    return std::make_unique<Direct>(techniques);
}

}  // namespace

const std::vector<NamedIntegrator>& integrators() {
    static const std::vector<NamedIntegrator> all{
        {"aov", "what is seen first: albedo, with normal and depth", "ours, integrators/aov.h",
         [](const PathLimits&) -> std::unique_ptr<PathEstimator> { return std::make_unique<Aov>(); }},
        {"direct", "direct light by samples of emitters and of BSDFs, power heuristic", "Veach & Guibas 1995",
         direct<LightTechniques::both>},
        {"direct-bsdf", "direct light by samples of BSDFs alone", "Veach & Guibas 1995", direct<LightTechniques::bsdf>},
        {"direct-emitters", "direct light by samples of emitters alone", "Veach & Guibas 1995",
         direct<LightTechniques::emitters>},
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

}  // namespace plumb
