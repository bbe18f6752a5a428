#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "verification/claim.h"

namespace plumb::checks {

/// A sampler in another process, and what it is to be judged by.
struct SamplerTrial {
    std::string command;  ///< of the shell, with {seed} and {n}
    std::string density;  ///< a name or a CSV file
    double delta = 0.05;  ///< the density error phi that `holds` excludes
    std::chrono::duration<double> timeout{60};
    std::uint64_t most_samples = 100'000'000;
};

/// Asks a sampler in another process for the samples that a verdict takes (docs/embedding.md has the protocol), and
/// returns the one claim that they come from the density: `sampler/density`. The process has ended when this returns,
/// so that its errors come before anything is written. Throws Error.
Catalogue sampler_catalogue(const SamplerTrial& trial, std::uint64_t seed, double alpha = 1e-4);

}  // namespace plumb::checks
