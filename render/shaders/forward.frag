#version 460
#extension GL_GOOGLE_include_directive : require
layout(constant_id = 0) const int kForm = 0;
layout(constant_id = 1) const bool kTextured = false;
#include "frame.glsl"
#include "rules.glsl"
#include "surface.glsl"
#include "brdf.glsl"
#include "shade.glsl"
layout(location = 0) out vec4 color;

void main() {
  const SurfaceHit s = surface(kTextured);
  if (!s.front) {
    color = vec4(frame.back_color.rgb, 1.0);
    return;
  }
  const vec3 position = items[s.item].model[3].xyz + s.relative;
  shadow_receiver = s.item;
  color = vec4(shade(kForm, position, normalize(position - frame.camera.xyz), s.normal, s.tangent, s.bitangent,
                     s.weights, items[s.item].form.z, s.shape),
               1.0);
}
