#pragma once

#include <cstdint>
#include <string_view>

#include "verification/run.h"

namespace plumb {

// This is what a check needs in a test suite that is not Plumb's, without a catalogue and a runner around it.

/// The false-alarm risk of one trial when none is given: a suite of 100 trials run every day raises a false alarm once
/// in 27 years.
inline constexpr double trial_alpha = 1e-6;

/// The seed of every trial of this process: the environment variable PLUMB_SEED, or a new seed, the same from then on.
/// Throws Error when PLUMB_SEED is not a whole number below 2^64.
std::uint64_t trial_seed();

/// The run that a check of the test suite is given. Its random numbers are a function of (trial_seed(), name) alone. In
/// the body of a TEST, write plumb::Run for the type: there Run is a function of GoogleTest's.
Run trial(std::string_view name, double alpha = trial_alpha);

}  // namespace plumb
