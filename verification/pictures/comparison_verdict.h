#pragma once

#include "verification/pictures/image_comparison.h"

namespace plumb {

/// Shares of alpha.
namespace parts_of_alpha {
constexpr double tiles = 1.0 / 2, chi_square = 1.0 / 8, means = 1.0 / 8, alike = 1.0 / 8, unlike = 1.0 / 8;
}

/// Whether a tile's mean says anything.
bool may_differ(const TileTest& tile);

/// Of two pictures of which one's error, or both's, is unknown: undecided, and what is missing.
Verdict no_verdict(const ImageComparison& found, const Picture& a, const Picture& b);

/// Of a comparison whose tests are done.
Verdict verdict_of(const ImageComparison& found, const Picture& a, const Picture& b,
                   const ComparisonSettings& settings);

}  // namespace plumb
