#pragma once

#include "scenes/textures/bitmap.h"
#include "scenes/textures/checkerboard.h"

namespace plumb::description {

/// All textures. Each has `at(u, v)`, or `prepared()`, a thing that has it.
using TextureModels = Types<Bitmap, Checkerboard>;

}  // namespace plumb::description
