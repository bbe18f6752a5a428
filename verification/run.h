#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/random.h"

namespace plumb {

/// Claims come in two sizes; a claim that has both takes its numbers from Run::pick.
enum class Size { quick, full };

/// What a check is given: its random numbers, its shares of the risks, its size.
/// Random numbers are a function of (run seed, claim id) alone, whatever else runs.
class Run {
public:
    Run(std::uint64_t seed, std::string_view id, double alpha, Size size = Size::quick,
        std::optional<std::chrono::steady_clock::time_point> deadline = {})
        : seed_(seed), stream_(stream_id(id)), id_(id), alpha_(alpha), size_(size), deadline_(deadline) {}

    /// The random numbers of sample or replicate `index`.
    [[nodiscard]] RandomStream random(std::uint64_t index) const { return RandomStream(seed_, stream_, index); }

    /// A run with random numbers of its own, for a check that draws for two purposes.
    [[nodiscard]] Run part(std::string_view name) const {
        return Run(seed_, id_ + "#" + std::string(name), alpha_, size_, deadline_);
    }

    /// The same with a share of alpha, for a check that decides several tests: shares must sum to at most 1.
    [[nodiscard]] Run part(std::string_view name, double share) const {
        return Run(seed_, id_ + "#" + std::string(name), alpha_ * share, size_, deadline_);
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
    [[nodiscard]] bool out_of_time() const { return deadline_ && std::chrono::steady_clock::now() > *deadline_; }

private:
    std::uint64_t seed_, stream_;
    std::string id_;
    double alpha_;
    Size size_;
    std::optional<std::chrono::steady_clock::time_point> deadline_;
};

}  // namespace plumb
