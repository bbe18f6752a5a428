#include "verification/suites/reweighting/subjects_2d.h"
#include "verification/suites/suites.h"

namespace plumb::suites {

void add_reweighting_2d_claims(Catalogue& catalogue) {
    add_reweighting_2d_area_claims(catalogue);
    add_reweighting_2d_torus_claims(catalogue);
    add_reweighting_2d_expected_cell_claims(catalogue);
    add_reweighting_2d_rate_claims(catalogue);
}

}  // namespace plumb::suites
