#pragma once

#include "verification/verdict.h"

namespace plumb::cli {

/// The exit code of a verb that ends in one verdict.
constexpr int exit_code(Outcome outcome) {
    return outcome == Outcome::holds ? 0 : outcome == Outcome::refuted ? 1 : 3;
}

}  // namespace plumb::cli
