#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/random.h"
#include "verification/run.h"

namespace plumb {

/// Watches draws that are claimed to be independent for what no independent ones show: correlation along the draws, and
/// few values that repeat. A verdict on draws that are not independent is worth nothing, so a test says this instead.
/// A false complaint is rarer than 1e-6, for any law whose values do not repeat by their nature.
/// docs/statistics.md, "Draws with a memory".
class Independence {
public:
    static constexpr std::size_t most_ranked = std::size_t{1} << 15;  ///< values that correlation is looked for in

    /// The next values, in the order of their indices.
    void add(std::span<const double> values);

    /// "draws are not independent: …", or empty where nothing shows.
    [[nodiscard]] std::string complaint() const;

private:
    void count(double value);
    [[nodiscard]] std::string of_repeated_values() const;

    std::uint64_t drawn_ = 0;
    std::vector<double> first_;  ///< for correlation along the draws
    // A sample of the values by their bits, with how often each came: all whose hash begins with so many zeros.
    std::unordered_map<std::uint64_t, std::uint64_t> counts_;
    int zeros_ = 0;
    bool few_values_ = false;  ///< plainly a discrete law: nothing is counted any more
};

/// How many indices are drawn again, in search of a state.
inline constexpr std::size_t draws_again = 8;

/// "draws are not independent: …" where the first indices, drawn again, give other values than these: the draw keeps a
/// state. Else empty.
std::string complaint_of_state(const std::function<double(RandomStream&)>& draw, std::span<const double> first,
                               const Run& run);

}  // namespace plumb
