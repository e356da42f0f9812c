#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
layout(push_constant) uniform Push { int item; } push;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;
layout(location = 0) out vec3 out_relative;  // to the object's origin: small numbers keep their digits in 16 bits
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_tangent;
layout(location = 3) out vec2 out_uv;

void main() {
  const mat4 model = items[push.item].model;
  out_relative = mat3(model) * position;
  out_normal = mat3(items[push.item].normals) * normal;
  out_tangent = vec4(mat3(model) * tangent.xyz, tangent.w);
  out_uv = uv;
  gl_Position = frame.view_projection * vec4(model[3].xyz + out_relative, 1.0);
}
