#include "cli/session.h"

#include <fmt/chrono.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "cli/stop_signal.h"
#include "cli/watched.h"
#include "core/file.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/version.h"

namespace plumb::cli {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

reports::TableStyle terminal_style() {
    reports::TableStyle style;
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

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) == 1) {}

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

void require_writable(const std::vector<std::string>& files) {
    for (const std::string& file : files)
        if (!file.empty()) plumb::check_writable(file);
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
