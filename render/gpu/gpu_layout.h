// The structs of shaders/frame.glsl, byte for byte.
#pragma once

#include <glm/glm.hpp>

#include "render/scene/scene.h"

namespace brdf::render {

struct GpuLight {
  glm::vec4 vector;
  glm::vec4 irradiance;
};

struct GpuFrame {
  glm::mat4 view_projection;
  glm::vec4 camera, right, up, forward;
  glm::vec4 ambient, back_color, background, zenith;
  glm::ivec4 counts;
  GpuLight lights[kMostLights];
};
static_assert(sizeof(GpuFrame) == 64 + 8 * 16 + 16 + 32 * kMostLights);

struct GpuItem {
  glm::mat4 model, normals;
  glm::vec4 weights[3];
  glm::vec4 shape, shape_low, shape_high;
  glm::ivec4 shape_roles, weight_roles, form;
  glm::vec4 weight_scale;
};
static_assert(sizeof(GpuItem) == 128 + 10 * 16);

inline constexpr std::size_t kMostItems = 224;  // 64 KiB of uniform buffer hold these

}  // namespace brdf::render
