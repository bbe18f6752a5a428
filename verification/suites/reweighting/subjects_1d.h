#pragma once

#include "verification/claim.h"

namespace plumb::suites {

// The parts of the 1D claims of geometric sample reweighting, by kind of evidence and subject.
void add_reweighting_1d_exact_claims(Catalogue& catalogue);
void add_reweighting_1d_bounded_claims(Catalogue& catalogue);
void add_reweighting_1d_mean_claims(Catalogue& catalogue);
void add_reweighting_1d_density_claims(Catalogue& catalogue);
void add_reweighting_1d_rate_claims(Catalogue& catalogue);

}  // namespace plumb::suites
