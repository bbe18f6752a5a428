#include "cli/judge_watched.h"

#include <unistd.h>

#include <cstdio>
#include <future>
#include <mutex>

#include "cli/stop_signal.h"

namespace plumb::cli {
namespace {

using clock = std::chrono::steady_clock;
constexpr auto tick = std::chrono::milliseconds(100);
constexpr auto patience = std::chrono::milliseconds(500);  // with checks that do not notice the stop

class Inbox {
public:
    void put(const Judged& one) {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(one);
    }
    std::vector<Judged> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(waiting_, {});
    }

private:
    std::mutex mutex_;
    std::vector<Judged> waiting_;
};

}  // namespace

int judge_watched(const Catalogue& catalogue, std::span<const Item> items, RunSetting setting, const Keep& keep,
                  const std::function<void(int)>& farewell) {
    const StopSignal signal;
    Inbox inbox;
    std::stop_source stop;
    setting.stop = stop.get_token();
    std::future<void> work = std::async(std::launch::async, [&] {
        (void)judge(catalogue, items, setting, [&](const Judged& one, std::size_t, std::size_t) { inbox.put(one); });
    });
    const auto keep_new = [&] {
        if (std::vector<Judged> judged = inbox.take(); !judged.empty()) keep(std::move(judged));
    };
    clock::time_point asked;
    try {
        while (work.wait_for(tick) != std::future_status::ready) {
            keep_new();
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
    work.get();
    keep_new();
    if (signal.caught()) farewell(signal.caught());
    return signal.caught();
}

}  // namespace plumb::cli
