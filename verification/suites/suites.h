#pragma once

#include "verification/claim.h"

namespace plumb::suites {

/// Every claim that Plumb makes of itself, in the order of the report: the closed catalogue.
Catalogue shipped_catalogue();

// One function a file of this folder.
void add_integrand_claims(Catalogue& catalogue);
void add_star_discrepancy_claims(Catalogue& catalogue);
void add_point_structure_claims(Catalogue& catalogue);
void add_point_set_claims(Catalogue& catalogue);
void add_point_variance_claims(Catalogue& catalogue);
void add_point_rate_claims(Catalogue& catalogue);
void add_error_bar_claims(Catalogue& catalogue);
void add_reweighting_1d_claims(Catalogue& catalogue);
void add_reweighting_2d_claims(Catalogue& catalogue);
void add_density_claims(Catalogue& catalogue);
void add_exact_mis_claims(Catalogue& catalogue);
void add_mis_claims(Catalogue& catalogue);
void add_variance_reduction_claims(Catalogue& catalogue);
void add_roulette_claims(Catalogue& catalogue);
void add_debiasing_claims(Catalogue& catalogue);
void add_forecast_claims(Catalogue& catalogue);
void add_calibration_claims_of_means(Catalogue& catalogue);
void add_calibration_claims_of_distributions(Catalogue& catalogue);
void add_calibration_claims_of_slopes(Catalogue& catalogue);
void add_calibration_claims_of_error_bars(Catalogue& catalogue);
void add_calibration_claims_of_functions(Catalogue& catalogue);
void add_calibration_claims_of_holes(Catalogue& catalogue);
void add_calibration_claims_of_cost(Catalogue& catalogue);
void add_warp_claims(Catalogue& catalogue);
void add_light_claims(Catalogue& catalogue);
void add_light_irradiance_claims(Catalogue& catalogue);
void add_light_rate_claims(Catalogue& catalogue);
void add_light_ray_claims(Catalogue& catalogue);
void add_camera_claims(Catalogue& catalogue);
void add_film_claims(Catalogue& catalogue);
void add_film_picture_claims(Catalogue& catalogue);
void add_direct_closed_form_claims(Catalogue& catalogue);
void add_direct_known_claims(Catalogue& catalogue);
void add_direct_pixel_claims(Catalogue& catalogue);
void add_direct_rate_claims(Catalogue& catalogue);
void add_direct_technique_claims(Catalogue& catalogue);
void add_direct_visibility_claims(Catalogue& catalogue);
void add_path_claims(Catalogue& catalogue);
void add_surface_claims(Catalogue& catalogue);
void add_texture_claims(Catalogue& catalogue);
void add_transport_class_claims(Catalogue& catalogue);
void add_transport_closed_claims(Catalogue& catalogue);
void add_transport_equal_claims(Catalogue& catalogue);
void add_transport_radiosity_claims(Catalogue& catalogue);
void add_transport_sampler_claims(Catalogue& catalogue);
void add_transport_weight_claims(Catalogue& catalogue);
void add_shift_jacobian_claims(Catalogue& catalogue);
void add_shift_pair_claims(Catalogue& catalogue);
void add_shift_replay_claims(Catalogue& catalogue);
void add_shift_round_trip_claims(Catalogue& catalogue);
void add_bsdf_model_claims(Catalogue& catalogue);  ///< every model against its own words
void add_bsdf_term_claims(Catalogue& catalogue);   ///< Fresnel's and the microfacets' terms in multi-precision
void add_compare_claims(Catalogue& catalogue);     ///< `plumb compare` on trial
void add_compare_render_claims(Catalogue& catalogue);

}  // namespace plumb::suites
