#include "cli/session.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <iterator>

#include "cli/stop_signal.h"
#include "cli/watched.h"
#include "core/error.h"
#include "core/file.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/version.h"

namespace plumb::cli {
namespace {

bool quiet = false;
int output_apart = -1;  // standard output, where words go elsewhere

// What is printed goes to standard error from now on.
void set_output_apart() {
    if (output_apart >= 0) return;
    std::fflush(stdout);
    output_apart = ::dup(STDOUT_FILENO);
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

reports::TableStyle terminal_style() {
    reports::TableStyle style;
    if (isatty(STDOUT_FILENO) != 1) style.width = reports::TableStyle::unlimited;
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= 60) style.width = size.ws_col;
    style.colour = isatty(STDOUT_FILENO) == 1 && !std::getenv("NO_COLOR");
    return style;
}

std::string time_left(double seconds, double share) {
    const double left = seconds * (1 - share) / share;
    if (!std::isfinite(left) || left < 0) return "";
    if (left < 100) return fmt::format(", about {:.0f} s left", left);
    return left < 6000 ? fmt::format(", about {:.0f} min left", left / 60)
                       : fmt::format(", about {:.1f} h left", left / 3600);
}

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) == 1 && !quiet) {}

ProgressLine::~ProgressLine() {
    clear();
}

void ProgressLine::clear() {
    if (terminal_) fmt::print(stderr, "\r\033[K");
}

void ProgressLine::show(std::string_view text) {
    if (!terminal_) return;
    fmt::print(stderr, "\r\033[K{}", text);
    std::fflush(stderr);
}

void be_quiet() {
    quiet = true;
    set_output_apart();
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDOUT_FILENO);
    ::close(nowhere);
}

void require_writable(const std::vector<std::string>& files) {
    if (std::ranges::count(files, "-") > 1) throw Error("two outputs are named '-', standard output");
    for (const std::string& file : files)
        if (file == "-")
            set_output_apart();
        else if (!file.empty())
            plumb::check_writable(file);
}

void write_output(const std::string& file, std::string_view text) {
    if (file != "-") return write_file(file, text);
    while (!text.empty()) {
        const ssize_t written = ::write(output_apart, text.data(), text.size());
        if (written < 0) throw Error(fmt::format("standard output cannot be written: {}", std::strerror(errno)));
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

std::string read_input(const std::string& file) {
    if (file != "-") return read_file(file);
    return {std::istreambuf_iterator<char>(std::cin), {}};
}

Session::Session(std::optional<std::uint64_t> seed, int threads) {
    run.seed = seed ? *seed : fresh_seed();
    run.threads = threads > 0 ? threads : hardware_threads();
    run.version = version;
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    run.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

void Session::work(const std::function<void()>& body, const std::string& if_stopped) {
    start_ = std::chrono::steady_clock::now();
    const auto farewell = [&](int signal) {
        line_.clear();
        fmt::print(stderr, "plumb: stopped by {}: {}\n", name_of_signal(signal), if_stopped);
    };
    const int signal = watched([&](const std::stop_token&) { with_threads(run.threads, body); }, [] {}, farewell);
    if (signal != 0) {
        std::fflush(nullptr);
        _exit(128 + signal);
    }
    line_.clear();
    run.seconds += seconds_since(start_);
}

void Session::show(double share, std::string_view what) {
    line_.show(fmt::format("{:3.0f} %{}: {}", 100 * share, time_left(seconds_since(start_), share), what));
}

}  // namespace plumb::cli
