#include "core/shard.h"

#include <charconv>

#include "core/error.h"

namespace plumb {

Shard parse_shard(const std::string& text) {
    constexpr int most = 10'000;
    Shard shard;
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, shard.index);
    const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
    const auto second = slash ? std::from_chars(first.ptr + 1, end, shard.count) : first;
    if (!slash || second.ec != std::errc() || second.ptr != end || shard.index < 1 || shard.index > shard.count ||
        shard.count > most)
        throw Error(fmt::format("'{}' is not a shard; accepted: i/n with 1 ≤ i ≤ n ≤ {}", text, most));
    return shard;
}

}  // namespace plumb
