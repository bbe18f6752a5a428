#include <algorithm>
#include <numeric>
#include <span>

#include "estimators/points/digital_net.h"

namespace plumb {
namespace {

/// Scrambles the digits of a group, sorted, that shares all digits above `unit`, the value of the next one.
void scramble_group(std::span<std::uint64_t> group, std::uint64_t unit, RandomStream& random) {
    if (group.empty() || unit == 0) return;
    if (group.size() == 1) {  // no one shares the remaining coins
        group[0] ^= random.bits() & (unit | (unit - 1));
        return;
    }
    const auto ones = std::partition_point(group.begin(), group.end(), [unit](std::uint64_t x) { return !(x & unit); });
    const auto zeros = static_cast<std::size_t>(ones - group.begin());
    if (random.bits() >> 63)
        for (std::uint64_t& x : group) x ^= unit;
    scramble_group(group.first(zeros), unit >> 1, random);
    scramble_group(group.subspan(zeros), unit >> 1, random);
}

}  // namespace

void owen_scramble(std::vector<std::uint64_t>& coordinate, RandomStream& random) {
    std::vector<std::uint32_t> order(coordinate.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(coordinate[i], i); });
    std::vector<std::uint64_t> sorted(coordinate.size());
    for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = coordinate[order[k]];
    scramble_group(sorted, std::uint64_t{1} << 63, random);
    for (std::size_t k = 0; k < order.size(); ++k) coordinate[order[k]] = sorted[k];
}

}  // namespace plumb
