#pragma once

#include <cstdint>
#include <optional>

#include "reports/run/results.h"
#include "reports/run/table.h"

namespace plumb::cli {

/// A run that starts now: the seed (a new one when none is given) and the threads (the hardware's when 0).
reports::RunInfo start_run(std::optional<std::uint64_t> seed, int threads);

/// Colour and width as standard output allows.
reports::TableStyle terminal_style();

/// Rewrites one line of standard error when that is a terminal, and is silent otherwise.
class ProgressLine {
public:
    ProgressLine();
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    void show(std::string_view text);
    void clear();

private:
    bool terminal_;
};

}  // namespace plumb::cli
