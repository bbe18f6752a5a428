#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/images/image.h"

namespace plumb {

/// An estimate of a picture and what is known of its error, pixel by pixel (rows from the top), channel by channel.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::string> channels;
    std::vector<double> mean = {};      ///< NaN where a value or its variance is not a finite number
    std::vector<double> variance = {};  ///< of the mean
    double degrees = 0;                 ///< of freedom of each variance; infinite for variances known exactly
    double rounding = 0;                ///< relative error of a stored number, by its format,
    double least_rounding = 0;          ///< and at least this, absolute
    double variance_rounding = 0;       ///< absolute error of a stored variance
    std::uint64_t renders = 1;          ///< independent images that the mean is of
    std::uint64_t bad_pixels = 0;       ///< that have a NaN
    /// The deviations of each render from their mean, where there are two or more renders.
    std::vector<std::vector<float>> residuals = {};

    [[nodiscard]] std::size_t at(int x, int y, std::size_t channel) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                   channels.size() +
               channel;
    }
    /// How far the k-th stored number may lie from the one that was rounded to it.
    [[nodiscard]] double rounding_at(std::size_t k) const {
        return std::fmax(rounding * std::abs(mean[k]), least_rounding);
    }
};

/// The mean of independent renders, in their channels R, G and B (or X, Y, Z; or Y). Its variance comes from layers
/// variance.R … with attribute plumb:replicates = R (R − 1 degrees of freedom each) where all of them have these, else
/// from the spread of k ≥ 2 renders (k − 1 degrees of freedom). With `exact`, the picture is a deterministic one,
/// without variance. `names` are those of the files, for messages. Throws Error saying what is missing, or which images
/// differ in size, or which two share their random numbers.
Picture picture_of(std::span<const Image> renders, std::span<const std::string> names, bool exact = false);

/// Whether each of the colours that picture_of() takes has its layer variance.…; throws Error where only some have one,
/// or as picture_of() does.
bool has_variance(const Image& image, const std::string& name);

/// Throws Error naming two images that have the same seed and scene in their metadata: they share samples, so that
/// the variance of their difference is not the sum of theirs.
void require_independent(std::span<const Image> images, std::span<const std::string> names);

}  // namespace plumb
