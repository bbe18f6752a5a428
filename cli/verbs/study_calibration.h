#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace plumb::cli {

struct CalibrationStudy {
    std::optional<std::uint64_t> seed, replicates;
    int threads = 0;
    std::string out;  ///< the folder; empty: out/study-calibration
};

/// The study `calibration`, which no file describes: what a verdict costs. Returns the program's exit code.
int study_calibration(const CalibrationStudy& options);

}  // namespace plumb::cli
