#include "core/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <thread>

#include "core/error.h"

namespace plumb {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t longest_line = 1 << 16;

struct Pipe {
    std::array<int, 2> ends{-1, -1};

    Pipe() {
        if (pipe2(ends.data(), O_CLOEXEC) != 0)
            throw Error(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_end(std::size_t end) {
        if (ends[end] >= 0) close(ends[end]);
        ends[end] = -1;
    }
};

class Deadline {
public:
    Deadline(const std::string& command, std::chrono::duration<double> limit)
        : command_(command), limit_(limit), end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(limit)) {}

    // More than 0; throws when none are left.
    [[nodiscard]] int milliseconds_left() const {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end_ - Clock::now()).count();
        if (left <= 0)
            throw Error(fmt::format("'{}' was not done after {:g} s and was stopped", command_, limit_.count()));
        return static_cast<int>(std::min<std::int64_t>(left, std::numeric_limits<int>::max()));
    }

private:
    std::string command_;
    std::chrono::duration<double> limit_;
    Clock::time_point end_;
};

// A command with a process group of its own, so that ending it ends what it started; it dies with this process.
class Child {
public:
    explicit Child(const std::string& command) {
        const pid_t parent = getpid();
        id_ = fork();
        if (id_ < 0) throw Error(fmt::format("cannot start '{}': {}", command, std::strerror(errno)));
        if (id_ == 0) {  // between fork and exec only what a signal handler may call
            setpgid(0, 0);
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            if (getppid() != parent) _exit(127);
            const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
            dup2(nothing, STDIN_FILENO);
            dup2(output.ends[1], STDOUT_FILENO);
            dup2(errors.ends[1], STDERR_FILENO);
            execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
            _exit(127);
        }
        setpgid(id_, id_);  // in both processes: neither may go on before it is so
        output.close_end(1);
        errors.close_end(1);
    }
    ~Child() {
        if (id_ <= 0) return;
        kill(-id_, SIGKILL);
        while (waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // What waitpid says of its end. A process that has closed its output ends soon, or is stuck.
    int wait(const Deadline& deadline) {
        int status = 0;
        while (waitpid(id_, &status, WNOHANG) != id_) {
            (void)deadline.milliseconds_left();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        kill(-id_, SIGKILL);  // what it left running
        id_ = 0;
        return status;
    }

    [[nodiscard]] pid_t id() const { return id_; }

    Pipe output, errors;

private:
    pid_t id_ = 0;
};

volatile pid_t group_to_end = 0;

void end_group_and_self(int signal) {
    kill(-group_to_end, SIGKILL);
    ::signal(signal, SIG_DFL);
    raise(signal);
}

// Its own process group does not hear the terminal: who interrupts this process ends the child's group with it.
class EndedTogether {
public:
    explicit EndedTogether(const Child& child) {
        group_to_end = child.id();
        for (std::size_t i = 0; i < signals.size(); ++i) {
            struct sigaction ending {};
            ending.sa_handler = end_group_and_self;
            sigaction(signals[i], nullptr, &before_[i]);
            if (before_[i].sa_handler != SIG_IGN) sigaction(signals[i], &ending, nullptr);
        }
    }
    ~EndedTogether() {
        for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
    }
    EndedTogether(const EndedTogether&) = delete;
    EndedTogether& operator=(const EndedTogether&) = delete;

private:
    static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, 3> before_{};
};

// Bytes that arrive, cut into lines.
class Lines {
public:
    // Returns false when take has had enough.
    bool add(std::string_view bytes, const std::function<bool(std::string_view)>& take) {
        rest_ += bytes;
        std::size_t begin = 0;
        for (std::size_t end; (end = rest_.find('\n', begin)) != std::string::npos; begin = end + 1)
            if (!take(std::string_view(rest_).substr(begin, end - begin))) return false;
        rest_.erase(0, begin);
        if (rest_.size() > longest_line)
            throw Error(fmt::format("more than {} bytes without an end of line", longest_line));
        return true;
    }
    // The last line needs no end.
    bool finish(const std::function<bool(std::string_view)>& take) { return rest_.empty() || take(rest_); }

private:
    std::string rest_;
};

std::string tail_of(const std::string& text) {
    return text.size() > longest_line ? text.substr(text.size() - longest_line) : text;
}

std::string last_line(std::string_view text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
    return std::string(text.substr(text.rfind('\n') + 1));
}

std::string end_of(int status) {
    if (WIFSIGNALED(status))
        return fmt::format("was ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
    return fmt::format("ended with exit code {}", WEXITSTATUS(status));
}

}  // namespace

bool read_lines(const std::string& command, std::chrono::duration<double> limit,
                const std::function<bool(std::string_view line)>& take) {
    Child child(command);
    const EndedTogether together(child);
    const Deadline deadline(command, limit);
    Lines lines;
    std::string errors;
    std::array<char, 1 << 16> bytes;
    std::array<pollfd, 2> open{{{child.output.ends[0], POLLIN, 0}, {child.errors.ends[0], POLLIN, 0}}};
    while (open[0].fd >= 0 || open[1].fd >= 0) {
        if (poll(open.data(), open.size(), deadline.milliseconds_left()) < 0 && errno != EINTR)
            throw Error(fmt::format("cannot read from '{}': {}", command, std::strerror(errno)));
        for (pollfd& one : open) {
            if (one.fd < 0 || one.revents == 0) continue;
            const ssize_t count = read(one.fd, bytes.data(), bytes.size());
            const std::string_view arrived(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
            if (&one == &open[1])
                errors = tail_of(errors += arrived);
            else if (!lines.add(arrived, take))
                return true;
            if (count == 0) one.fd = -1;
        }
    }
    const int status = child.wait(deadline);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw Error(fmt::format("'{}' {}{}", command, end_of(status), errors.empty() ? "" : ": " + last_line(errors)));
    return !lines.finish(take);
}

}  // namespace plumb
