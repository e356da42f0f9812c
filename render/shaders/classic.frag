#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "classic.glsl"
layout(push_constant) uniform Push { int item; } push;
layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec3 in_color;
layout(location = 3) in vec2 in_coordinates;
layout(set = 1, binding = 0) uniform sampler2D table;
layout(location = 0) out vec4 color;

// Cm (Ca + n.l Cd) + Cs table(n.h, n.l). As the article codes it, n.l is added to the ambient before any clamp.
vec3 looked_up() {
  const Item item = items[push.item];
  const vec3 irradiance = frame.counts.x > 0 ? irradiance_of(frame.lights[0], in_position) : vec3(0.0);
  const vec2 at = kPerVertex ? in_coordinates : lookup_coordinates(in_position, normalize(in_normal));
  const float cosine = kAsCoded ? at.y : max(at.y, 0.0);
  const vec3 diffuse = item_weight(item, item.form.z) * max(frame.ambient.rgb + cosine * irradiance, 0.0);
  const float seen = kAsCoded || at.y > 0.0 ? 1.0 : 0.0;
  return diffuse + seen * item_weight(item, item.form.w) * irradiance * texture(table, at).r;
}

void main() {
  vec3 c = in_color;
  if (!kPerVertex && (kShading == shading_phong || kShading == shading_phong_blinn)) {
    const vec3 n = kAsCoded ? in_normal : normalize(in_normal);  // the article never renormalises
    c = lit(item_weight(items[push.item], items[push.item].form.z), in_position, n, kShading == shading_phong_blinn);
  }
  if (kShading == shading_lookup) c = looked_up();
  const bool has_back = kShading != shading_vertex_color && kShading != shading_lookup;
  if (has_back && !gl_FrontFacing) c = frame.back_color.rgb;
  color = vec4(c, 1.0);
}
