#pragma once

#include <string>
#include <vector>

#include "reports/run/table.h"
#include "verification/pictures/known_values.h"

namespace plumb::reports {

/// A check with what was checked.
struct ValuesReport {
    std::vector<std::string> files;
    std::string expected;  ///< the file that says what is known
    const Picture& picture;
    const std::vector<KnownValue>& known;
    CheckSettings settings;
    const ValuesCheck& check;
};

/// The JSON that `plumb check --json` writes (docs/json.md).
std::string values_json(const ValuesReport& report);

/// The check as text, a line for each value.
std::string values_table(const ValuesReport& report, const TableStyle& style = {});

}  // namespace plumb::reports
