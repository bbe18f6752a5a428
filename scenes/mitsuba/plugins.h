#pragma once

#include <string>
#include <vector>

namespace plumb {

/// A thing that a scene file may ask for: <kind type="name">.
struct Plugin {
    std::string kind;  ///< shape, bsdf, texture, emitter, sensor, film or rfilter
    std::string name;
    std::string summary;  ///< one line
};

/// All plugins that the loader knows, by kind and name. A plugin exists only when a shipped scene uses it and a claim
/// checks it: verification/suites/features_test.cpp.
const std::vector<Plugin>& known_plugins();

/// The names of one kind. Throws Error where there is no such kind.
std::vector<std::string> plugin_names(const std::string& kind);

}  // namespace plumb
