#include "estimators/points/point_count.h"

#include <fmt/format.h>

#include <limits>

#include "core/error.h"

namespace plumb {

std::uint32_t point_count(std::uint64_t n, std::string_view point_set) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    if (n > most) throw Error(fmt::format("point set {}: n = {}; at most {} points are accepted", point_set, n, most));
    return static_cast<std::uint32_t>(n);
}

}  // namespace plumb
