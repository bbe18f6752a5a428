#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace plumb {

/// Runs a command of the shell (/bin/sh -c) and hands over the lines of its standard output, one at a time and without
/// their ends, until take returns false, the output ends, or the time is up. The command and all that it started are
/// ended before this returns. Returns whether take had enough (true), or the output ended and the command with it,
/// successfully (false). Throws Error when the command cannot be run, fails (the message has the last line of its
/// standard error), or needs longer than the limit. One call at a time: an interrupted process (SIGINT,
/// SIGTERM, SIGHUP) ends the command with itself.
bool read_lines(const std::string& command, std::chrono::duration<double> limit,
                const std::function<bool(std::string_view line)>& take);

}  // namespace plumb
