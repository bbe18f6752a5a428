#pragma once

#include "verification/claim.h"

namespace plumb {

/// Every claim that Plumb makes of itself, in the order of the report: the closed catalogue.
Catalogue shipped_catalogue();

// One function a group, one group a file of this folder.
void add_error_bar_claims(Catalogue& catalogue);
void add_point_rate_claims(Catalogue& catalogue);
void add_point_set_claims(Catalogue& catalogue);
void add_point_structure_claims(Catalogue& catalogue);
void add_point_variance_claims(Catalogue& catalogue);
void add_reweighting_2d_claims(Catalogue& catalogue);
void add_star_discrepancy_claims(Catalogue& catalogue);

}  // namespace plumb
