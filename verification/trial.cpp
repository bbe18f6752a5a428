#include "verification/trial.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>

#include "core/error.h"

namespace plumb {
namespace {

std::uint64_t seed_from_environment() {
    const char* const given = std::getenv("PLUMB_SEED");
    if (!given) return fresh_seed();
    const std::string_view text = given;
    std::uint64_t seed = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (failure != std::errc() || end != text.data() + text.size())
        throw Error(fmt::format("PLUMB_SEED is '{}'; accepted: a whole number below 2^64", text));
    return seed;
}

}  // namespace

std::uint64_t trial_seed() {
    static const std::uint64_t seed = seed_from_environment();
    return seed;
}

Run trial(std::string_view name, double alpha) {
    return Run(trial_seed(), name, alpha);
}

}  // namespace plumb
