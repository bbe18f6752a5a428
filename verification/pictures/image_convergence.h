#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "verification/evidence/convergence.h"
#include "verification/pictures/picture.h"

namespace plumb {

/// Independent renders of one picture with equally many samples a pixel; their own variances are not looked at.
struct RendersAt {
    std::uint64_t samples = 0;
    std::vector<std::string> files = {};
    std::vector<Picture> renders = {};
    double seconds = std::numeric_limits<double>::quiet_NaN();  ///< mean of a render; NaN: not known
};

/// The error of renders against a reference, over pixels that are finite everywhere and channels. What the reference's
/// own variance adds to the MSE is subtracted. The error of the MSE comes from how renders with equally many samples
/// differ, in blocks of 8 x 8 pixels, which may be correlated within; for a single render from how its blocks differ,
/// which is more. Throws Error naming a file whose size or channels are not the reference's.
ConvergencePoint convergence_point(const RendersAt& at, const Picture& reference);

/// The power ⟨b² − v⟩ of a picture b with the variance v: an MSE divided by it is a relMSE.
double power_of(const Picture& picture);

}  // namespace plumb
