#pragma once

#include <utility>
#include <vector>

#include "core/spectrum.h"

namespace plumb {

/// Wavelengths in nm, ascending, with values; linear between them, 0 outside.
using TabulatedSpectrum = std::vector<std::pair<double, double>>;

/// Linear sRGB of a reflectance under D65: 1 everywhere becomes (1, 1, 1).
Spectrum reflectance_rgb(const TabulatedSpectrum& spectrum);
/// Linear sRGB of an emission, the luminance of the constant 1 being 1. The equal-energy white is not sRGB's: constant
/// emission is a little red.
Spectrum emission_rgb(const TabulatedSpectrum& spectrum);

}  // namespace plumb
