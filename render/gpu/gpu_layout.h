// Definitions shared by C++ and the shaders: limits, the targets, and the structs of shaders/frame.glsl
// byte for byte. shaders/emit_shaders.cpp writes the limits and enumerators as layout.glsl.
#pragma once

#include <glm/glm.hpp>

#include "render/scene/scene.h"

namespace brdf {
namespace render {

// The seven targets that the geometry is drawn into.
enum class Target { albedo, normal, specular, position, roughness, tangent, bitangent };
inline constexpr int kTargetCount = 7;

// As many items as fit into 64 KiB of uniform buffer.
inline constexpr std::size_t kMostItems = 224;
// Numbers of parameters that the shaders' arguments have room for. In the targets, the fourth shape
// parameter takes the place of a third weight's red. A form with a third weight therefore has no room for a
// fourth shape parameter.
inline constexpr std::size_t kMostWeights = 3, kMostShape = 4;
constexpr std::size_t most_shape(std::size_t weights) {
  return weights < kMostWeights ? kMostShape : kMostShape - 1;
}
inline constexpr int kFourthShape = 16;  // bit of GpuItem::form.y: the form has a fourth shape parameter
// 16-bit targets also store the rounding remainder of the normal, multiplied by this factor, along tangent
// and bitangent.
inline constexpr int kRemainderScale = 4096;
// Kinds of background in GpuFrame::counts.y: one colour (0), a sky, a backdrop.
inline constexpr int kSky = 1, kBackdrop = 2;
// GpuFrame::environment.w if the environment has no floor: lower than any floor.
inline constexpr float kNoFloor = -1e9f;

struct GpuLight {
  glm::vec4 vector;
  glm::vec4 irradiance;
};

struct GpuFrame {
  glm::mat4 view_projection;
  glm::vec4 camera, right, up, forward;
  glm::vec4 ambient, back_color, background, zenith;
  glm::vec4 environment;
  glm::ivec4 counts;
  glm::mat4 shadow_projection;
  glm::vec4 shadow;
  GpuLight lights[kMostLights];
};
static_assert(sizeof(GpuFrame) == 64 + 9 * 16 + 16 + 64 + 16 + 32 * kMostLights);

struct GpuItem {
  glm::mat4 model, normals;
  glm::vec4 weights[kMostWeights];
  glm::vec4 shape, shape_low, shape_high;
  glm::ivec4 shape_rules, weight_rules, form;
  glm::vec4 weight_scale;
};
static_assert(sizeof(GpuItem) == 128 + 10 * 16);

}  // namespace render

template <>
inline constexpr std::array<std::string_view, render::kTargetCount> kNames<render::Target>{
    "albedo", "normal", "specular", "position", "roughness", "tangent", "bitangent"};

}  // namespace brdf
