#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include "core/random.h"

namespace plumb {

/// The two sizes of claims; a claim that has both takes its numbers from Run::pick.
enum class Size { quick, full };

/// Thrown through a check when its run is asked to end: there is no verdict then. Not an error, and no std::exception,
/// so that no handler of errors takes it for one.
struct Stopped {};

/// The random numbers, the shares of the risks and the size that a check is given. Random numbers are a function of
/// (run seed, claim id) alone, whatever else runs.
class Run {
public:
    Run(std::uint64_t seed, std::string_view id, double alpha, Size size = Size::quick, std::stop_token stop = {})
        : seed_(seed), stream_(stream_id(id)), id_(id), alpha_(alpha), size_(size), stop_(std::move(stop)) {}

    /// The random numbers of sample or replicate `index`. Throws Stopped once the run is asked to end, so that whatever
    /// draws ends within the time of one draw.
    [[nodiscard]] RandomStream random(std::uint64_t index) const {
        end_if_stopped();
        return RandomStream(seed_, stream_, index);
    }
    /// Throws Stopped once the run is asked to end: for long work that draws nothing.
    void end_if_stopped() const {
        if (stop_.stop_requested()) end();
    }

    /// A run with random numbers of its own, for a check that draws for two purposes.
    [[nodiscard]] Run part(std::string_view name) const {
        return Run(seed_, id_ + "#" + std::string(name), alpha_, size_, stop_);
    }

    /// A part with a share of alpha, for a check that decides several tests: shares must sum to at most 1.
    [[nodiscard]] Run part(std::string_view name, double share) const {
        return Run(seed_, id_ + "#" + std::string(name), alpha_ * share, size_, stop_);
    }

    /// The claim's share of the run's false-alarm budget.
    [[nodiscard]] double alpha() const { return alpha_; }
    /// The risk of a wrong `holds` when the deviation is at least delta.
    [[nodiscard]] double beta() const { return 0.01; }
    [[nodiscard]] Size size() const { return size_; }
    template <class T>
    [[nodiscard]] T pick(T quick, T full) const {
        return size_ == Size::quick ? quick : full;
    }

private:
    [[noreturn, gnu::cold, gnu::noinline]] static void end() { throw Stopped(); }

    std::uint64_t seed_, stream_;
    std::string id_;
    double alpha_;
    Size size_;
    std::stop_token stop_;
};

}  // namespace plumb
