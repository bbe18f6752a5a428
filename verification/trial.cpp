#include "verification/trial.h"

#include <fmt/format.h>

#include <cstdlib>

#include "core/error.h"
#include "core/numbers.h"

namespace plumb {
namespace {

std::uint64_t seed_from_environment() {
    const char* const given = std::getenv("PLUMB_SEED");
    if (!given) return fresh_seed();
    if (const auto seed = number_of<std::uint64_t>(given)) return *seed;
    throw Error(fmt::format("PLUMB_SEED is '{}'; accepted: a whole number below 2^64", given));
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
