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
    bool error_known = true;            ///< else nothing is known of it, and variances are 0
    double rounding = 0;                ///< relative error of a stored number, by its format,
    double least_rounding = 0;          ///< and at least this, absolute
    double variance_rounding = 0;       ///< absolute error of a stored variance
    std::uint64_t renders = 1;          ///< independent images that the mean is of
    double samples = 0;                 ///< of a pixel, of all renders together; 0: they do not say
    std::uint64_t bad_pixels = 0;       ///< that have a NaN
    /// The deviations of each render from their mean, where there are two or more renders.
    std::vector<std::vector<float>> residuals = {};
    /// Channel by channel, the variance of the mean over all pixels, of as many degrees of freedom; empty where images
    /// do not say it.
    std::vector<double> mean_variance = {};

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
/// variance.R … with attribute plumb:replicates = R (R − 1 degrees of freedom each) where all of them have these, and
/// that of its means from attributes plumb:error_of_means; else
/// from the spread of k ≥ 2 renders (k − 1 degrees of freedom). With `exact`, the picture is a deterministic one,
/// without variance. `names` are those of the files, for messages. Throws Error saying what is missing, or which images
/// differ in size, or which two share their random numbers.
Picture picture_of(std::span<const Image> renders, std::span<const std::string> names, bool exact = false);

/// The picture of one image whose error is unknown, of floats or of integers, which are sRGB unless the file says
/// another encoding. Throws Error as picture_of() does, and for an encoding that is neither linear, sRGB nor a power.
Picture picture_without_error(const Image& image, const std::string& name);

/// Whether each of the colours that picture_of() takes has its layer variance.…; throws Error where only some have one,
/// or as picture_of() does.
bool has_variance(const Image& image, const std::string& name);

/// Throws Error naming two images that have the same seed and scene in their metadata: they share samples, so that
/// the variance of their difference is not the sum of theirs.
void require_independent(std::span<const Image> images, std::span<const std::string> names);

}  // namespace plumb
