#pragma once

#include "verification/claim.h"

namespace plumb {

/// Every claim that Plumb makes of itself, in the order of the report: the closed catalogue.
Catalogue shipped_catalogue();

// One function a group, one group a file of this folder.
void add_reweighting_2d_claims(Catalogue& catalogue);

}  // namespace plumb
