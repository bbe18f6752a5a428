#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "core/file.h"
#include "core/test_folder.h"

namespace plumb::cli {

/// The real program, running in a folder of its own with its output in files beside it.
class Program {
public:
    struct Limits {
        rlim_t file_size = RLIM_INFINITY;  ///< bytes: what a full disk looks like
        const char* standard_output = nullptr;
    };
    Program(const std::filesystem::path& folder, const std::vector<std::string>& arguments)
        : Program(folder, arguments, Limits()) {}
    Program(const std::filesystem::path& folder, const std::vector<std::string>& arguments, const Limits& limits)
        : log_(folder.string() + ".log") {
        std::vector<const char*> argv = {PLUMB_PROGRAM};
        for (const std::string& argument : arguments) argv.push_back(argument.c_str());
        argv.push_back(nullptr);
        const std::string output = limits.standard_output ? limits.standard_output : log_ + ".out";
        process_ = ::fork();
        if (process_ != 0) return;
        const rlimit size{limits.file_size, RLIM_INFINITY};
        if (::chdir(folder.c_str()) != 0 || !std::freopen(output.c_str(), "w", stdout) ||
            !std::freopen((log_ + ".err").c_str(), "w", stderr) || ::setrlimit(RLIMIT_FSIZE, &size) != 0)
            ::_exit(99);
        ::execv(PLUMB_PROGRAM, const_cast<char**>(argv.data()));
        ::_exit(99);
    }
    ~Program() {
        wait();
        for (const char* suffix : {".out", ".err"}) std::filesystem::remove(log_ + suffix);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void send(int signal) const { ::kill(process_, signal); }
    /// Waits until the program has a handler of its own for the signal, two minutes at most.
    void wait_until_it_catches(int signal) const {
        const std::string status = "/proc/" + std::to_string(process_) + "/status", key = "SigCgt:";
        for (int times = 0; times < 12'000; ++times) {
            const std::string text = read_file(status);
            const std::uint64_t mask = std::stoull(text.substr(text.find(key) + key.size()), nullptr, 16);
            if ((mask >> (signal - 1) & 1) != 0) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }
    /// Waits for the end. Returns the exit code, or −signal when a signal ended the program.
    int wait() {
        int status = 0;
        if (!ended_ && ::waitpid(process_, &status, 0) == process_) {
            ended_ = true;
            code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
        }
        return code_;
    }
    [[nodiscard]] std::string errors() const { return read_file(log_ + ".err"); }

private:
    std::string log_;
    pid_t process_ = -1;
    bool ended_ = false;
    int code_ = -1;
};

}  // namespace plumb::cli
