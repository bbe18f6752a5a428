#pragma once

#include <memory>
#include <string>
#include <vector>

#include "integrators/estimators/bdpt.h"
#include "integrators/estimators/light.h"
#include "integrators/estimators/path.h"

namespace plumb {

/// An integrator that a user can ask for by name.
struct NamedIntegrator {
    std::string id, summary, source;
    std::unique_ptr<PathEstimator> (*make)(const PathLimits&);
};

const std::vector<NamedIntegrator>& integrators();
/// Throws Error naming the nearest ones.
const NamedIntegrator& find_integrator(const std::string& id);
/// The integrator of that name, held to all limits: `length` too. Throws Error for a strategy of another than `bdpt`,
/// and for `direct` and its kind with a longest path of other than 2 edges.
std::unique_ptr<PathEstimator> make_integrator(const std::string& id, PathLimits limits);

}  // namespace plumb
