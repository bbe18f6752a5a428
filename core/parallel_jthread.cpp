// The executor for ThreadSanitizer, which reports false races inside a correct oneTBB.

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "core/parallel.h"

namespace plumb {
namespace {

thread_local int threads_allowed = static_cast<int>(std::thread::hardware_concurrency());

}  // namespace

void for_batches(std::size_t count, const std::function<void(std::size_t)>& body) {
    const auto threads = static_cast<std::size_t>(std::max(1, threads_allowed));
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failure_mutex;
    const auto work = [&] {
        threads_allowed = 1;  // a nested loop runs where it is
        for (std::size_t i = next++; i < count; i = next++) try {
                body(i);
            } catch (...) {
                const std::lock_guard lock(failure_mutex);
                if (!failure) failure = std::current_exception();
                next = count;
            }
    };
    if (threads == 1 || count < 2) {
        const int allowed = threads_allowed;
        work();
        threads_allowed = allowed;
    } else {
        std::vector<std::jthread> pool;
        for (std::size_t t = 0; t < std::min(threads, count); ++t) pool.emplace_back(work);
    }
    if (failure) std::rethrow_exception(failure);
}

void with_threads(int threads, const std::function<void()>& body) {
    const int before = threads_allowed;
    threads_allowed = threads;
    body();
    threads_allowed = before;
}

int hardware_threads() {
    return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace plumb
