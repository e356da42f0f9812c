// Parts of procedural shapes: surfaces over two parameters, and copies of meshes.
#pragma once

#include <functional>
#include <vector>

#include "render/mesh/mesh.h"

namespace brdf::render {

using Surface = std::function<glm::vec3(float u, float v)>;

// Returns the surface over all pairs of these parameters. Cells for which `kept` returns false are omitted.
// `outwards` is the sign of d/du x d/dv.
Mesh loft(const Surface& at, const std::vector<float>& us, const std::vector<float>& vs, float outwards,
          const std::function<bool(float u, float v)>& kept = {});
// Returns the borders with interval k cut into pieces[k] pieces.
std::vector<float> divided(const std::vector<float>& borders, const std::vector<int>& pieces);

// Returns the mesh together with its mirror image in z.
Mesh mirrored(const Mesh& half);
// Returns the mesh scaled, turned about y by turn_y degrees, and moved to `at`.
Mesh placed(const Mesh& mesh, glm::vec3 at, glm::vec3 scale = glm::vec3(1), float turn_y = 0);

}  // namespace brdf::render
