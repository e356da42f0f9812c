// Parts of shapes made by code: surfaces over two parameters, and copies of meshes.
#pragma once

#include <functional>
#include <vector>

#include "render/mesh/mesh.h"

namespace brdf::render {

using Surface = std::function<glm::vec3(float u, float v)>;

// The surface over all pairs of these parameters, but for the cells that are left out; `outwards` is the sign
// of d/du x d/dv.
Mesh loft(const Surface& at, const std::vector<float>& us, const std::vector<float>& vs, float outwards,
          const std::function<bool(float u, float v)>& kept = {});
// The values with each interval cut into so many pieces.
std::vector<float> divided(const std::vector<float>& borders, const std::vector<int>& pieces);

// With its mirror image in z.
Mesh mirrored(const Mesh& half);
// Scaled, turned about y by so many degrees, moved.
Mesh placed(const Mesh& mesh, glm::vec3 at, glm::vec3 scale = glm::vec3(1), float turn_y = 0);

}  // namespace brdf::render
