#pragma once

#include <string>

#include "core/error.h"

namespace plumb::description {

/// The place in the scene's files where a thing was written.
struct Place {
    std::string file = {};
    int line = 0;
    /// An Error that reads `file:line: message`.
    [[nodiscard]] Error error(const std::string& message) const {
        return Error(file + ":" + std::to_string(line) + ": " + message);
    }
};

}  // namespace plumb::description
