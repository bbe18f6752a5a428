#include "verification/suites/suites.h"

namespace plumb::suites {

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
    add_calibration_claims_of_means(catalogue);
    add_calibration_claims_of_distributions(catalogue);
    add_calibration_claims_of_slopes(catalogue);
    add_calibration_claims_of_error_bars(catalogue);
    add_calibration_claims_of_functions(catalogue);
    add_calibration_claims_of_holes(catalogue);
    add_calibration_claims_of_cost(catalogue);
    add_warp_claims(catalogue);
    add_light_claims(catalogue);
    add_light_irradiance_claims(catalogue);
    add_light_rate_claims(catalogue);
    add_light_ray_claims(catalogue);
    add_camera_claims(catalogue);
    add_film_claims(catalogue);
    add_film_picture_claims(catalogue);
    add_direct_closed_form_claims(catalogue);
    add_direct_known_claims(catalogue);
    add_direct_pixel_claims(catalogue);
    add_direct_rate_claims(catalogue);
    add_direct_technique_claims(catalogue);
    add_direct_visibility_claims(catalogue);
    add_path_claims(catalogue);
    add_surface_claims(catalogue);
    add_texture_claims(catalogue);
    add_bsdf_model_claims(catalogue);
    add_bsdf_term_claims(catalogue);
    add_transport_class_claims(catalogue);
    add_transport_closed_claims(catalogue);
    add_transport_equal_claims(catalogue);
    add_transport_radiosity_claims(catalogue);
    add_transport_sampler_claims(catalogue);
    add_transport_weight_claims(catalogue);
    add_shift_jacobian_claims(catalogue);
    add_shift_pair_claims(catalogue);
    add_shift_replay_claims(catalogue);
    add_shift_round_trip_claims(catalogue);
    add_compare_claims(catalogue);
    add_compare_render_claims(catalogue);
    return catalogue;
}

}  // namespace plumb::suites
