#pragma once

#include "core/parameters.h"
#include "integrators/drivers/driver.h"

namespace plumb {

/// A driver that a user can ask for by name.
struct NamedDriver {
    std::string id, summary, source;
    std::vector<Parameter> parameters;
    /// The driver for a job that has none yet: it learns here what it has to learn of the scene.
    std::unique_ptr<Driver> (*make)(const RenderJob& job, const Parameters& parameters);
};

/// All drivers.
const std::vector<NamedDriver>& drivers();
/// The driver of this name. Throws Error naming the nearest ones.
const NamedDriver& find_driver(const std::string& id);

}  // namespace plumb
