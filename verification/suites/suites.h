#pragma once

#include "verification/claim.h"

namespace plumb::suites {

/// Every claim that Plumb makes of itself, in the order of the report: the closed catalogue. CMakeLists.txt lists the
/// files of claims, and plumb_claims() writes this function from the list.
Catalogue shipped_catalogue();

}  // namespace plumb::suites
