#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/study/study_result.h"
#include "verification/series.h"

namespace plumb {

/// The error of images that somebody has, against samples a pixel.
struct ImageSeries {
    Series series;
    std::vector<std::uint64_t> images;  ///< at each point of the series
    double power = 0;                   ///< of the reference: what an MSE is divided by to be a relMSE
    std::string said;                   ///< the truth in words
};

/// Measures the images that match the pattern (image_pattern.h) against the image `reference`, whose own variance is
/// subtracted where it is known. Throws Error.
ImageSeries measure_images(const std::string& pattern, const std::string& reference);

/// The series and its slope for a terminal of so many columns.
std::string text_of(const ImageSeries& measured, int columns);

/// All series against their one reference in one figure, which has the page and the plot of a study.
reports::StudyResult figure_of(const std::vector<ImageSeries>& all, const reports::RunInfo& run);

/// A row for each point of each series: pattern, reference, spp, images, seconds, mse, mse_low, mse_high, relmse, bias,
/// bias_standard_error. RFC 4180, numbers in full, an unknown number as an empty cell.
std::string csv_of(const std::vector<ImageSeries>& all);

}  // namespace plumb
