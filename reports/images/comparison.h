#pragma once

#include <string>
#include <vector>

#include "verification/pictures/image_comparison.h"

namespace plumb::reports {

/// A comparison together with what was compared.
struct ComparisonReport {
    std::vector<std::string> files_a, files_b;
    const Picture &a, &b;
    ComparisonSettings settings;
    const ImageComparison& found;
};

/// The JSON that `plumb compare --json` writes (docs/json.md): everything but the pixels.
std::string comparison_json(const ComparisonReport& report);

/// The comparison as one HTML page that needs nothing else: both pictures as floats, and how much and where they
/// differ.
std::string comparison_html(const ComparisonReport& report);

}  // namespace plumb::reports
