#pragma once

#include <string>

#include "core/estimate.h"

namespace plumb {

/// The largest standard error that is asked for: absolute, or relative to the value.
struct ErrorTarget {
    double error = 0;
    bool relative = false;

    [[nodiscard]] double absolute(double value) const;
    [[nodiscard]] bool met_by(const Estimate& estimate) const {
        return estimate.standard_error <= absolute(estimate.value);
    }
};

/// The target "1e-3" (absolute) or "1%" (relative); throws Error unless it is finite and above 0.
ErrorTarget parse_error_target(const std::string& text);

}  // namespace plumb
