#include "verification/suites/suites.h"

namespace plumb {

Catalogue shipped_catalogue() {
    Catalogue catalogue;
    add_integrand_claims(catalogue);
    add_star_discrepancy_claims(catalogue);
    add_point_structure_claims(catalogue);
    add_point_set_claims(catalogue);
    add_point_variance_claims(catalogue);
    add_point_rate_claims(catalogue);
    add_error_bar_claims(catalogue);
    add_reweighting_1d_claims(catalogue);
    add_reweighting_2d_claims(catalogue);
    add_density_claims(catalogue);
    add_exact_mis_claims(catalogue);
    add_mis_claims(catalogue);
    add_variance_reduction_claims(catalogue);
    add_roulette_claims(catalogue);
    add_debiasing_claims(catalogue);
    add_forecast_claims(catalogue);
    add_bsdf_model_claims(catalogue);
    add_bsdf_term_claims(catalogue);
    add_calibration_claims(catalogue);
    return catalogue;
}

}  // namespace plumb
