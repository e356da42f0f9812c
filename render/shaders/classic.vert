#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "classic.glsl"
layout(push_constant) uniform Push { int item; } push;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in vec2 uv;
layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec3 out_color;
layout(location = 3) out vec2 out_coordinates;

// Once round the colour circle.
vec3 rainbow(float x) {
  return clamp(abs(mod(x * 6.0 + vec3(0.0, 4.0, 2.0), 6.0) - 3.0) - 1.0, 0.0, 1.0);
}

void main() {
  const mat4 model = items[push.item].model;
  out_position = model[3].xyz + mat3(model) * position;
  out_normal = normalize(mat3(items[push.item].normals) * normal);
  const vec3 object_color = item_weight(items[push.item], items[push.item].form.z);
  out_color = vec3(0.0);
  out_coordinates = vec2(0.0);
  if (kShading == shading_vertex_color) out_color = rainbow(uv.x);
  if (kShading == shading_flat || kShading == shading_gouraud) {
    out_color = lit(object_color, out_position, out_normal, false);
  }
  if (kPerVertex && (kShading == shading_phong || kShading == shading_phong_blinn)) {
    out_color = lit(object_color, out_position, out_normal, kShading == shading_phong_blinn);
  }
  if (kShading == shading_lookup && kPerVertex) out_coordinates = lookup_coordinates(out_position, out_normal);
  gl_Position = frame.view_projection * vec4(out_position, 1.0);
}
