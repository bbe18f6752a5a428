#pragma once

#include <string>

#include "core/error.h"

namespace plumb::description {

/// Where in the scene's files a thing was written.
struct Place {
    std::string file = {};
    int line = 0;
    /// `file:line: message`.
    [[nodiscard]] Error error(const std::string& message) const {
        return Error(file + ":" + std::to_string(line) + ": " + message);
    }
};

}  // namespace plumb::description
