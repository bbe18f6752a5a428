#pragma once

#include "verification/pictures/known_values.h"

namespace plumb {

/// Of a check whose tests are done. It holds where all values do, and where they hold together and each is no worse than
/// too noisy to tell alone.
Verdict verdict_of(const ValuesCheck& check, const Picture& picture, std::span<const KnownValue> known,
                   const CheckSettings& settings);

}  // namespace plumb
