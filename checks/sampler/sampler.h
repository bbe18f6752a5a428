#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checks/sampler/cell_density.h"
#include "core/error_target.h"
#include "verification/claim.h"

namespace plumb::checks {

/// A program in another process that prints samples or values, and what it is to be judged by: a density, the density
/// that it prints itself ("own"), or a mean.
struct SamplerTrial {
    std::string command;                 ///< of the shell, with {seed} and {n}
    std::string density = {};            ///< a name, a CSV file, "own" or a formula; empty: its lines are values
    std::optional<double> mean = {};     ///< that the values are claimed to have
    std::optional<ErrorTarget> delta{};  ///< what `holds` excludes; 0.05 of a density where it is not given
    std::chrono::duration<double> timeout{60};
    std::uint64_t most_samples = 100'000'000;
    std::uint64_t samples = std::uint64_t{1} << 18;  ///< lines of values, and of samples with their own densities
    std::vector<double> domain = {};                 ///< of formulas and own densities: x0, x1[, y0, y1]; empty: unit

    /// Reads a formula where there is somebody who can (the engine knows none).
    std::function<CellDensity(const std::string& text, const std::vector<double>& domain)> formula = {};
};

/// Asks a program in another process for the lines that a verdict takes (docs/embedding.md has the protocol), and
/// returns the claims about them: `sampler/density`, and of own densities `sampler/normalisation`; or `sampler/mean`.
/// The process has ended when this returns, so that its errors come before anything is written. Throws Error.
Catalogue sampler_catalogue(const SamplerTrial& trial, std::uint64_t seed, double alpha = 1e-4);

}  // namespace plumb::checks
