#pragma once

#include <memory>
#include <string>
#include <vector>

#include "integrators/path.h"

namespace plumb {

/// An integrator that a user can ask for by name.
struct NamedIntegrator {
    std::string id, summary, source;
    std::unique_ptr<PathEstimator> (*make)(const PathLimits&);
};

const std::vector<NamedIntegrator>& integrators();
/// Throws Error naming the nearest ones.
const NamedIntegrator& find_integrator(const std::string& id);

}  // namespace plumb
