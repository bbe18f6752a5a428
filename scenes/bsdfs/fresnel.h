#pragma once

#include "core/spectrum.h"

namespace plumb {

/// The light that a smooth interface reflects, and the direction of the rest.
struct DielectricFresnel {
    double reflectance;  ///< of unpolarised light; the rest is transmitted
    double cos_t;        ///< of the refracted direction, in [0, 1]; 0 when all is reflected
};

/// What happens to light that meets a smooth interface under cos_i in [0, 1]; eta > 0 is the index of the far side over
/// that of the near side. The relative error of reflectance and transmittance is a few ulp of the larger, at grazing
/// incidence, at equal indices and on both sides of the critical angle alike.
DielectricFresnel fresnel_dielectric(double cos_i, double eta);

/// The reflectance of a conductor of index eta + i k, relative to the near side, for unpolarised light under cos_i.
double fresnel_conductor(double cos_i, double eta, double k);
Spectrum fresnel_conductor(double cos_i, const Spectrum& eta, const Spectrum& k);

/// The mean of the dielectric's reflectance over uniform light from the whole near hemisphere, 2 ∫ F cosθ dcosθ. The
/// means from both sides of an interface satisfy eta² (1 − mean(1/eta)) = 1 − mean(eta).
double mean_fresnel_dielectric(double eta);

}  // namespace plumb
