#include "cli/session.h"

#include <fmt/chrono.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "core/file.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/version.h"

namespace plumb::cli {

reports::TableStyle terminal_style() {
    reports::TableStyle style;
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= 60) style.width = size.ws_col;
    style.colour = isatty(STDOUT_FILENO) == 1 && !std::getenv("NO_COLOR");
    return style;
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

void Session::work(const std::function<void()>& body) {
    const auto start = std::chrono::steady_clock::now();
    with_threads(run.threads, body);
    line_.clear();
    run.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace plumb::cli
