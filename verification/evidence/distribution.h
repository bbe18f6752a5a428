#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/random.h"
#include "verification/run.h"
#include "verification/verdict.h"

namespace plumb {

/// The cell (0 … cells−1) of one independent sample. Failed samples are a cell of their own; a value outside
/// 0 … cells−1 counts as a hit where the density is zero and refutes.
using DrawCell = std::function<std::size_t(RandomStream&)>;

/// A claim that samples fall into cells with these probabilities.
struct DistributionClaim {
    std::vector<double> probabilities;  ///< of the cells; must sum to 1 within 1e-9, zeros allowed
    double delta = 0;                   ///< the effect size phi = sqrt(sum (p−q)²/q) that `holds` excludes
    std::vector<double> errors = {};    ///< how far each probability may be from what is claimed; empty: not at all
};

/// The verdict on whether draws fall into the cells with these probabilities: Pearson's chi-square at the sample count
/// that makes `undecided` though true rarer than 1e-5; `holds` by the noncentral chi-square. docs/statistics.md,
/// "Distributions". Undecided where the draws have a memory (Independence) or the counts are more even than chance.
/// Throws Error when 2^32 samples would not do: so rare a cell belongs to a neighbour.
Verdict distribution_is(const DrawCell& draw, const DistributionClaim& claim, const Run& run);

/// The count that every cell must expect for the chi-square's tail to be within 1.3 times its level at alpha.
double least_expected_count(double alpha);

/// The number of samples that a verdict takes: enough that a true claim is `undecided` with a probability of 1e-5 at
/// most, and that every cell of positive probability expects least_expected_count().
std::uint64_t distribution_samples(const DistributionClaim& claim, double alpha, double beta);

/// The verdict on given counts. Where degrees_of_freedom < 0, it is the number of cells of positive probability less 1.
Verdict chi_square_verdict(std::span<const std::uint64_t> counts, const DistributionClaim& claim, double alpha,
                           double beta, int degrees_of_freedom = -1);

/// The cell of a one-dimensional sample in [0,1), of `cells` equal ones.
std::size_t equal_cell(double u, std::size_t cells);

}  // namespace plumb
