#pragma once

#include <cstddef>
#include <functional>

namespace plumb {

/// Runs body(0) … body(count − 1), in any order and on the threads that with_threads() allows; returns when all are
/// done. Bodies write to places of their own; whoever needs an order merges afterwards by batch number, so results do
/// not depend on the number of threads. May be called inside a body. An exception of a body is thrown here.
void for_batches(std::size_t count, const std::function<void(std::size_t)>& body);

/// Runs body with for_batches limited to that many threads (≥ 1).
void with_threads(int threads, const std::function<void()>& body);

/// The number of threads that the hardware offers.
int hardware_threads();

}  // namespace plumb
