#pragma once

#include <cstdint>

#include "cli/options.h"
#include "verification/claim.h"

namespace plumb::cli {

/// Asks a sampler in another process for the samples that a verdict takes (docs/embedding.md has the protocol), and
/// returns the one claim that they come from the density: `sampler/density`. The process has ended when this returns,
/// so that its errors come before anything is written. Throws Error.
Catalogue sampler_catalogue(const SamplerOptions& options, std::uint64_t seed, double alpha = 1e-4);

}  // namespace plumb::cli
