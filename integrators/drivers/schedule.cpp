#include "integrators/drivers/schedule.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

#include "core/parallel.h"

namespace plumb {

namespace {

struct Piece {
    std::uint32_t pass;
    std::size_t number;
};

class Schedule {
public:
    explicit Schedule(const PassWork& work) : work_(work) {}

    // Works in one thread, until nothing is left.
    void work() {
        try {
            while (const auto piece = next()) {
                work_.make(piece->pass, piece->number);
                finish_in_order(piece->pass);
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            end();
            throw;
        }
    }
    [[nodiscard]] ScheduleWaits waits() const { return waits_; }

private:
    std::optional<Piece> next() {
        std::unique_lock lock(mutex_);
        const auto can_go_on = [this] {
            return ended_ || next_.number > 0 || next_.pass == work_.passes || next_.pass - finished_ < work_.in_flight;
        };
        if (!can_go_on()) {
            ++waits_.count;
            finished_one_.wait(lock, can_go_on);
        }
        if (ended_ || next_.pass == work_.passes) return {};
        if (next_.number == 0) {
            work_.begin(next_.pass);
            left_.push_back(work_.pieces);
        }
        const Piece piece = next_;
        next_ = piece.number + 1 < work_.pieces ? Piece{piece.pass, piece.number + 1} : Piece{piece.pass + 1, 0};
        return piece;
    }

    // The piece of the pass is made. One thread at a time finishes passes, while the others go on.
    void finish_in_order(std::uint32_t pass) {
        std::unique_lock lock(mutex_);
        --left_[pass - finished_];
        if (finishing_) return;
        finishing_ = true;
        while (!ended_ && !left_.empty() && left_.front() == 0) {
            lock.unlock();
            const bool more = work_.finish(finished_);
            lock.lock();
            left_.pop_front();
            ++finished_;
            if (!more) ended_ = true;
            finished_one_.notify_all();
        }
        finishing_ = false;
    }

    void end() {
        ended_ = true;
        finished_one_.notify_all();
    }

    const PassWork& work_;
    std::mutex mutex_;
    std::condition_variable finished_one_;
    Piece next_{0, 0};
    std::deque<std::size_t> left_;  // pieces of the passes that are begun and not finished
    std::uint32_t finished_ = 0;
    bool finishing_ = false, ended_ = false;
    ScheduleWaits waits_;
};

}  // namespace

ScheduleWaits work_off(const PassWork& work) {
    Schedule schedule(work);
    const auto threads = static_cast<std::size_t>(hardware_threads());
    for_batches(std::min(threads, work.pieces * work.passes), [&](std::size_t) { schedule.work(); });
    return schedule.waits();
}

std::size_t passes_in_flight(std::size_t pieces, std::size_t threads, std::size_t bytes_of_image) {
    const std::size_t wanted = 1 + (4 * threads + pieces - 1) / pieces;
    return std::max<std::size_t>(2, std::min(wanted, (std::size_t{1} << 28) / bytes_of_image));
}

}  // namespace plumb
