#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "core/parallel.h"

namespace plumb {

void for_batches(std::size_t count, const std::function<void(std::size_t)>& body) {
    // Isolated: a thread that waits here takes up batches of this loop only, so that an outer body is never started
    // inside an inner one and its seconds stay its own.
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(
            std::size_t{0}, count, [&](std::size_t i) { body(i); }, tbb::simple_partitioner());
    });
}

void with_threads(int threads, const std::function<void()>& body) {
    tbb::task_arena(threads).execute(body);
}

int hardware_threads() {
    return tbb::this_task_arena::max_concurrency();
}

}  // namespace plumb
