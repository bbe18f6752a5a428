#pragma once

#include <string>
#include <vector>

#include "core/vec3.h"

namespace plumb::checks {

/// 25 directions: outside from the normal to half a degree above the surface, then inside likewise.
std::vector<Vec3> check_directions();

/// "30° outside": the angle to the normal, and the side.
std::string name_of(Vec3 direction);

}  // namespace plumb::checks
