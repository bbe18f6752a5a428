#pragma once

#include <string>
#include <vector>

#include "core/vec3.h"

namespace plumb::checks {

/// The 25 directions of the checks: outside from the normal to half a degree above the surface, then inside likewise.
std::vector<Vec3> check_directions();

/// A direction in words: "30° outside", the angle to the normal and the side.
std::string name_of(Vec3 direction);

}  // namespace plumb::checks
