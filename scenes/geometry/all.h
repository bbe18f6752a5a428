#pragma once

#include "scenes/geometry/disk.h"
#include "scenes/geometry/mesh_shapes.h"
#include "scenes/geometry/sphere.h"

namespace plumb::description {

/// All shapes. Each is loaded as a mesh, or as itself where it is an AnalyticShape.
using ShapeModels = Types<ObjMesh, PlyMesh, RectangleMesh, CubeMesh, Sphere, Disk>;

}  // namespace plumb::description
