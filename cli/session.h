#pragma once

#include <chrono>
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

/// How long the rest takes when `share` of the work took so many seconds, e.g. ", about 12 s left"; empty where nobody
/// can know yet.
std::string time_left(double seconds, double share);

/// From now on nothing is said but errors: --quiet.
void be_quiet();

/// Throws Error for the first file that cannot be written, before the work instead of after it. An empty name is no
/// file; "-" is standard output, which is its alone from now on: what verbs say goes to standard error.
void require_writable(const std::vector<std::string>& files);

/// Makes the text the whole content of the file, which may be "-" where require_writable() was told of it.
void write_output(const std::string& file, std::string_view text);

/// The whole of a file, or of standard input for "-".
std::string read_input(const std::string& file);

/// The things that verbs which draw random numbers have in common: a run with its seed (a new one when none is given),
/// threads (the hardware's when 0) and seconds, a line of progress, and an end by SIGINT or SIGTERM that says so.
class Session {
public:
    Session(std::optional<std::uint64_t> seed, int threads);

    /// Works on the run's threads and adds the seconds to the run; the line of progress is gone afterwards. SIGINT and
    /// SIGTERM end the program within a second, with exit code 128 + the signal and a line that says what became of
    /// the outputs: `if_stopped`.
    void work(const std::function<void()>& body, const std::string& if_stopped = "nothing is saved");
    void show(std::string_view progress) { line_.show(progress); }
    /// Shows what is worked at, the share of the work that is done and the time that the rest takes.
    void show(double share, std::string_view what);

    reports::RunInfo run;

private:
    std::chrono::steady_clock::time_point start_;
    ProgressLine line_;
};

}  // namespace plumb::cli
