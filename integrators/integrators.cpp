#include "integrators/integrators.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/named.h"
#include "integrators/estimators/aov.h"
#include "integrators/estimators/direct.h"
#include "integrators/estimators/one_length.h"

namespace plumb {

namespace {

const Parameter roulette_start{"roulette-start", "edges of a path behind which Russian roulette begins",
                               Parameter::Integer{PathLimits{}.roulette_edges, 0, 30000}};

template <class Estimator>
std::unique_ptr<PathEstimator> with_roulette(const PathLimits& limits, const Parameters& parameters) {
    PathLimits own = limits;
    if (parameters.given(roulette_start.name))
        own.roulette_edges = static_cast<int>(parameters.integer(roulette_start.name));
    return std::make_unique<Estimator>(own);
}

template <TechniqueCounts counts>
std::unique_ptr<PathEstimator> direct(const PathLimits&, const Parameters&) {
    return std::make_unique<Direct>(counts);
}

std::unique_ptr<PathEstimator> aov(const PathLimits&, const Parameters&) {
    return std::make_unique<Aov>();
}

void check_limits(const NamedIntegrator& named, const PathLimits& limits) {
    const Makes& makes = named.makes;
    if (limits.strategy && !makes.strategies) {
        std::vector<std::string> others;
        for (const NamedIntegrator& other : integrators())
            if (other.makes.strategies) others.push_back(other.id);
        throw Error(
            fmt::format("a strategy of the integrator '{}'; accepted is {}", named.id, fmt::join(others, " or ")));
    }
    if (makes.longest && limits.max_edges >= 0 && limits.max_edges != *makes.longest)
        throw Error(
            fmt::format("paths of up to {} edges by the integrator '{}', whose paths have {}; accepted are {} and -1",
                        limits.max_edges, named.id, *makes.longest, *makes.longest));
}

}  // namespace

const std::vector<NamedIntegrator>& integrators() {
    static const std::vector<NamedIntegrator> all{
        {"aov",
         "what is seen first: albedo, with normal and depth",
         "ours, integrators/estimators/aov.h",
         {.radiance = false},
         {},
         aov},
        {"bdpt",
         "all light: subpaths from the sensor and from a light, connected in all ways",
         "[Veach & Guibas 1994]",
         {.strategies = true, .path = bdpt_makes, .rank = 3},
         {roulette_start},
         with_roulette<Bdpt>},
        {"direct",
         "direct light by samples of lights and of BSDFs, power heuristic",
         "[Veach & Guibas 1995]",
         {.longest = 2, .path = direct_makes, .rank = 1},
         {},
         direct<one_of_each>},
        {"direct-bsdf",
         "direct light by samples of BSDFs alone",
         "[Veach & Guibas 1995]",
         {.longest = 2, .path = direct_bsdf_makes},
         {},
         direct<bsdf_alone>},
        {"direct-emitters",
         "direct light by samples of lights alone",
         "[Veach & Guibas 1995]",
         {.longest = 2, .path = direct_emitters_makes},
         {},
         direct<lights_alone>},
        {"light",
         "light traced from its sources, each vertex connected to the lens",
         "[Arvo 1986]",
         {.path = light_makes},
         {roulette_start},
         with_roulette<LightTracer>},
        {"path",
         "all light: light and BSDF samples at each vertex of a path from the sensor",
         "[Kajiya 1986]",
         {.path = path_makes, .rank = 2},
         {roulette_start},
         with_roulette<PathTracer>},
    };
    return all;
}

const NamedIntegrator* known_integrator(const std::string& id) {
    const auto found = std::ranges::find(integrators(), id, &NamedIntegrator::id);
    return found == integrators().end() ? nullptr : &*found;
}

const NamedIntegrator& find_integrator(const std::string& id) {
    return find_named(integrators(), id, "integrator");
}

std::vector<const NamedIntegrator*> reference_integrators() {
    std::vector<const NamedIntegrator*> ranked;
    for (const NamedIntegrator& integrator : integrators())
        if (integrator.makes.rank > 0) ranked.push_back(&integrator);
    std::ranges::sort(ranked, std::greater(), [](const NamedIntegrator* one) { return one->makes.rank; });
    return ranked;
}

std::unique_ptr<PathEstimator> make_integrator(const std::string& id, PathLimits limits,
                                               const ParameterTexts& parameters) {
    const NamedIntegrator& named = find_integrator(id);
    check_limits(named, limits);
    if (limits.length > 0 && limits.max_edges < 0) limits.max_edges = limits.length;  // no longer path is asked for
    auto estimator = named.make(limits, Parameters(named.parameters, parameters));
    if (limits.length == 0) return estimator;
    return std::make_unique<OneLength>(std::move(estimator), limits.length);
}

}  // namespace plumb
