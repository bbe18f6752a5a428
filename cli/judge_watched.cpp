#include "cli/judge_watched.h"

#include <mutex>

#include "cli/watched.h"

namespace plumb::cli {
namespace {

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
    Inbox inbox;
    const auto work = [&](const std::stop_token& stop) {
        setting.stop = stop;
        (void)judge(catalogue, items, setting, [&](const Judged& one, std::size_t, std::size_t) { inbox.put(one); });
    };
    const auto keep_new = [&] {
        if (std::vector<Judged> judged = inbox.take(); !judged.empty()) keep(std::move(judged));
    };
    return watched(work, keep_new, farewell);
}

}  // namespace plumb::cli
