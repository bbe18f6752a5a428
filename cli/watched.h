#pragma once

#include <functional>
#include <stop_token>

namespace plumb::cli {

/// Works in a thread of its own, so that SIGINT and SIGTERM end the program within a second: then a stop is asked for,
/// `farewell` is called and the signal returned; 0 when the work was done. Work that does not notice the stop within
/// half a second is abandoned with the process, whose exit code is then 128 + the signal. `often` is called in the
/// caller's thread every tenth of a second and once at the end. What the work throws is thrown here.
int watched(const std::function<void(const std::stop_token& stop)>& work, const std::function<void()>& often,
            const std::function<void(int signal)>& farewell);

}  // namespace plumb::cli
