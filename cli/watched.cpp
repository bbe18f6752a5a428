#include "cli/watched.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <future>

#include "cli/stop_signal.h"

namespace plumb::cli {
namespace {

using clock = std::chrono::steady_clock;
constexpr auto tick = std::chrono::milliseconds(100);
constexpr auto patience = std::chrono::milliseconds(500);  // with work that does not notice the stop

}  // namespace

int watched(const std::function<void(const std::stop_token&)>& work, const std::function<void()>& often,
            const std::function<void(int)>& farewell) {
    const StopSignal signal;
    std::stop_source stop;
    std::future<void> done = std::async(std::launch::async, [&] { work(stop.get_token()); });
    clock::time_point asked;
    try {
        while (done.wait_for(tick) != std::future_status::ready) {
            often();
            if (!signal.caught()) continue;
            if (stop.request_stop()) asked = clock::now();
            if (clock::now() < asked + patience) continue;
            farewell(signal.caught());
            std::fflush(nullptr);
            _exit(128 + signal.caught());
        }
    } catch (...) {
        stop.request_stop();  // before the future waits for its thread
        throw;
    }
    done.get();
    often();
    if (signal.caught()) farewell(signal.caught());
    return signal.caught();
}

}  // namespace plumb::cli
