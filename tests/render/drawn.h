// Draws one frame with the deferred renderer and returns the picture.
#pragma once

#include "render/gpu/renderer.h"
#include "render/scene/prepared.h"

namespace brdf::render {

inline Picture drawn(Device& device, const PreparedScene& scene, const RendererOptions& options = {}) {
  Renderer renderer(device, scene, options);
  renderer.draw();
  return picture_from(scene.scene.camera.width, scene.scene.camera.height, renderer.read_color());
}
inline Picture drawn(Device& device, const Scene& scene) {
  return drawn(device, prepare(scene));
}

}  // namespace brdf::render
