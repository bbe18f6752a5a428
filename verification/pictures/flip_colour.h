#pragma once

#include <array>

namespace plumb::flip {

// The colours of FLIP [Andersson et al. 2020]: three numbers, of linear sRGB or of an opponent space.

using Triple = std::array<double, 3>;

/// YCxCz of linear sRGB: L*a*b* without its curve, so that filtering it is filtering light.
Triple opponent_of(const Triple& rgb);
/// The inverse of opponent_of().
Triple rgb_of(const Triple& opponent);
/// Linear sRGB of XYZ.
Triple rgb_of_xyz(const Triple& xyz);
/// L*a*b* of linear sRGB.
Triple lab_of(const Triple& rgb);
/// The same with a* and b* times L*/100: dark colours seem less colourful [Hunt 1952].
Triple hunt_adjusted(const Triple& lab);
/// |ΔL| + √(Δa² + Δb²) [Abasi et al. 2020].
double hyab(const Triple& one, const Triple& other);
/// The error in [0, 1] of a distance of Hunt-adjusted colours: its power of 0.7, of which the first 40 % of the largest
/// (of green and blue) are spread over 0 to 0.95.
double colour_error(double distance);

}  // namespace plumb::flip
