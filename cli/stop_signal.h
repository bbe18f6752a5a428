#pragma once

namespace plumb::cli {

/// A guard that only notes the first SIGINT or SIGTERM while it lives; the second ends the program at once. A signal
/// that was ignored when the program started (nohup, a job in the background) stays ignored.
class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    /// The signal that came; 0 for none.
    [[nodiscard]] static int caught();
};

/// "SIGINT" or "SIGTERM".
const char* name_of_signal(int signal);

}  // namespace plumb::cli
