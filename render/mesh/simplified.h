// A mesh with fewer triangles, for pictures that are shown for a moment.
#pragma once

#include "render/mesh/mesh.h"

namespace brdf::render {

// Divides the mesh's bounding cube into cells^3 cells and merges the vertices of each cell into one of them,
// so that all vertices stay on the surface; triangles within a cell vanish. Vertices of a cell keep separate
// normals if their normals point into different octants, which preserves sharp edges. The surface has no new
// gaps. Returns the mesh itself if all its triangles would vanish.
Mesh simplified(const Mesh& mesh, int cells);

}  // namespace brdf::render
