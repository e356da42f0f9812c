#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
// The scene as the light that casts a shadow sees it.
layout(push_constant) uniform Push { int item; } push;
layout(location = 0) in vec3 position;

void main() {
  const mat4 model = items[push.item].model;
  gl_Position = frame.shadow_projection * vec4(model[3].xyz + mat3(model) * position, 1.0);
}
