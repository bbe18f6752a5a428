#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace plumb {

constexpr std::uint64_t most_samples = std::uint64_t{1} << 32;

/// The counts that "16..65536" (doubling from the first) or "16,100,1000" (sorted, each once) says; throws Error.
std::vector<std::uint64_t> parse_sample_counts(const std::string& text);

}  // namespace plumb
