#pragma once

#include <string>
#include <vector>

#include "core/spectrum.h"

namespace plumb {

/// A conductor's complex index of refraction eta + i k against vacuum, in linear sRGB lanes.
struct ComplexIndex {
    Spectrum eta, k;
};

/// The index of a metal by Mitsuba's name (Cu, Au, …). The values in RGB are those that the renderer Tungsten lists
/// (ComplexIorData.hpp), which projected the measured spectra that Mitsuba ships (SOPRA, Palik, CRC). Throws Error for
/// an unknown name, listing the known ones.
ComplexIndex metal(const std::string& name);
std::vector<std::string> metal_names();

/// The index of a transparent medium at 589 nm by Mitsuba's name (bk7, water, …). Throws Error for an unknown name.
double named_index(const std::string& name);

}  // namespace plumb
