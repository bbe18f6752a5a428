#pragma once

#include <cstdint>
#include <string_view>

namespace plumb {

/// n as the 32-bit index that permutations and digital sequences count with; throws Error for n ≥ 2^32.
std::uint32_t point_count(std::uint64_t n, std::string_view point_set);

}  // namespace plumb
