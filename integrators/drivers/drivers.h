#pragma once

#include "core/parameters.h"
#include "integrators/drivers/driver.h"

namespace plumb {

/// A driver that a user can ask for by name.
struct NamedDriver {
    std::string id, summary, source;
    std::vector<Parameter> parameters;
    /// For a job that has none yet: what the driver learns of the scene, it learns here.
    std::unique_ptr<Driver> (*make)(const RenderJob& job, const Parameters& parameters);
};

const std::vector<NamedDriver>& drivers();
/// Throws Error naming the nearest ones.
const NamedDriver& find_driver(const std::string& id);

}  // namespace plumb
