#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/run/results.h"
#include "reports/run/table.h"

namespace plumb::cli {

/// The colour and width that standard output allows.
reports::TableStyle terminal_style();

/// A line of standard error that is rewritten where that is a terminal; it is silent otherwise.
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

/// Throws Error for the first file that cannot be written, before the work instead of after it. An empty name is no
/// file.
void require_writable(const std::vector<std::string>& files);

/// The things that verbs which draw random numbers have in common: a run with its seed (a new one when none is given),
/// threads (the hardware's when 0) and seconds, and a line of progress.
class Session {
public:
    Session(std::optional<std::uint64_t> seed, int threads);

    /// Works on the run's threads and adds the seconds to the run; the line of progress is gone afterwards.
    void work(const std::function<void()>& body);
    void show(std::string_view progress) { line_.show(progress); }

    reports::RunInfo run;

private:
    ProgressLine line_;
};

}  // namespace plumb::cli
