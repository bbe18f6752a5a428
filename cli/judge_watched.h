#pragma once

#include <functional>
#include <span>
#include <vector>

#include "verification/runner.h"

namespace plumb::cli {

/// A listener that is called in the caller's thread, at most a tenth of a second after a verdict, with the verdicts
/// that came since.
using Keep = std::function<void(std::vector<Judged>)>;

/// Judges the items in threads of their own, so that SIGINT and SIGTERM end the run within a second: what is open then
/// is dropped, what was judged is kept, `farewell` is called and the signal returned. Returns 0 when everything was
/// judged. A check that does not notice the stop (because it draws nothing for long) is abandoned with the process,
/// whose exit code is then 128 + the signal.
int judge_watched(const Catalogue& catalogue, std::span<const Item> items, RunSetting setting, const Keep& keep,
                  const std::function<void(int signal)>& farewell);

}  // namespace plumb::cli
