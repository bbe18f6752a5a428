#pragma once

#include <string>

namespace plumb {

/// The i-th of n parts of some work, 1 ≤ i ≤ n.
struct Shard {
    int index = 1, count = 1;
};

/// "i/n" as a shard of at most 10,000; throws Error.
Shard parse_shard(const std::string& text);

}  // namespace plumb
