#pragma once

#include <utility>
#include <vector>

#include "core/spectrum.h"

namespace plumb {

/// Wavelengths in nm, ascending, with values: linear between them, 0 outside.
using TabulatedSpectrum = std::vector<std::pair<double, double>>;

/// The linear sRGB of a reflectance under D65: 1 everywhere becomes (1, 1, 1).
Spectrum reflectance_rgb(const TabulatedSpectrum& spectrum);
/// The linear sRGB of an emission, scaled so that the constant 1 has luminance 1. Equal-energy white is not sRGB's
/// white: constant emission is a little red.
Spectrum emission_rgb(const TabulatedSpectrum& spectrum);

}  // namespace plumb
