#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "verification/evidence/deterministic.h"

namespace plumb::suites {

/// A count of cases with the description of the first that fails.
struct Tally {
    std::uint64_t cases = 0;
    std::string failure;

    void expect(bool right, const auto& describe) {
        ++cases;
        if (!right && failure.empty()) failure = describe();
    }
    [[nodiscard]] Verdict verdict(std::string_view what) const {
        const std::string result = failure.empty() ? fmt::format("all {} {}", cases, what) : failure;
        return exactly(failure.empty(), cases, result);
    }
};

}  // namespace plumb::suites
