#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/parameters.h"
#include "integrators/estimators/bdpt.h"
#include "integrators/estimators/light_tracer.h"
#include "integrators/estimators/path.h"
#include "integrators/references/path_classes.h"

namespace plumb {

/// The kinds of pictures that an integrator makes, and the paths that it counts.
struct Makes {
    bool radiance = true;             ///< all light of paths up to some length; not so of albedos
    std::optional<int> longest = {};  ///< edges of its longest paths, where that is not for the limits to say
    bool strategies = false;          ///< one strategy (s, t) alone, where it is asked for
    MakesPath path = nullptr;         ///< which classes of paths; null where there is no light
    int rank = 0;                     ///< who is asked for a reference: the highest first; 0: nobody asks
};

/// An integrator that a user can ask for by name.
struct NamedIntegrator {
    std::string id, summary, source;
    Makes makes;
    std::vector<Parameter> parameters;
    std::unique_ptr<PathEstimator> (*make)(const PathLimits& limits, const Parameters& parameters);
};

/// All integrators.
const std::vector<NamedIntegrator>& integrators();
/// The integrator of this name; null where there is none.
const NamedIntegrator* known_integrator(const std::string& id);
/// The integrator of this name. Throws Error naming the nearest ones.
const NamedIntegrator& find_integrator(const std::string& id);
/// The integrators whose pictures are references, the one that makes most kinds of paths first.
std::vector<const NamedIntegrator*> reference_integrators();

/// The integrator of that name, held to all limits, `length` too. Throws Error for a strategy of an integrator that
/// makes none alone, for a longest path of another length than the integrator's own, and for a parameter that is not
/// accepted.
std::unique_ptr<PathEstimator> make_integrator(const std::string& id, PathLimits limits,
                                               const ParameterTexts& parameters = {});

}  // namespace plumb
