#pragma once

#include <string>
#include <vector>

#include "core/random.h"
#include "core/vec3.h"
#include "verification/run.h"

namespace plumb::checks {

/// The directions of what must be integrated: the normal, and one drawn from each of 14 zones outside and 10 inside,
/// from the normal to 89.97°.
std::vector<Vec3> check_directions(const Run& run);

/// A direction of either side, for what is asked at single directions: uniform in its angle to the normal, but one in
/// four within 0.2 of the horizon and one in eight within 0.2 of the normal, at a distance that is uniform in its
/// logarithm down to 1e-4.
Vec3 any_direction(RandomStream& random);

/// "40° outside": the angle to the normal, and the side.
std::string name_of(Vec3 direction);
/// "wo 40° outside, wi 43.1° outside, 3.1° from the mirrored direction".
std::string in_words(Vec3 wo, Vec3 wi);

}  // namespace plumb::checks
