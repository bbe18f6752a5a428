#pragma once

#include <string>
#include <vector>

#include "verification/pictures/image_comparison.h"

namespace plumb {

/// By which factor the samples of both sides must grow until a difference is likely to be decided (nine times in ten):
/// by an interval inside delta, or by a refutation beyond epsilon at this level. The truth is taken for the difference
/// found where the interval excludes 0, else for none. Standard errors fall as 1/√n, and so does skewness, which must
/// let the interval be trusted. At least 2; infinite where the difference is as large as what is allowed, or where
/// there is no noise that could fall.
double more_samples(const MeanDifference& found, double epsilon, double level, double beta);

/// What an undecided verdict says of the samples that would decide it.
struct SamplesNeeded {
    double factor = 1;
    bool tails = false;    ///< skewness forbids a forecast: the factor is the least
    bool unknown = false;  ///< something shows no variance, or is not known well enough: no number is known

    /// Takes what another undecided difference needs, too.
    void add(const MeanDifference& found, TileState state);
};
/// A clause on them, in samples of a pixel where the pictures say how many they have; empty where nothing was added.
std::string words_of(const SamplesNeeded& needed, const std::vector<const Picture*>& sides);

}  // namespace plumb
