#version 460
#extension GL_GOOGLE_include_directive : require
layout(constant_id = 0) const int kForm = 0;  // one pipeline per form: a uniform branch would evaluate all of them
layout(constant_id = 1) const int kBits = 16;
layout(constant_id = 2) const bool kSingle = false;  // only one item has this form: its data are the same for all pixels
// Only an environment lights the scene: the pass marks the surfaces, and most targets are not read.
layout(constant_id = 3) const bool kDark = false;
layout(push_constant) uniform Push { int item; } push;
#include "frame.glsl"
#include "brdf.glsl"
#include "shade.glsl"
#include "stored_surface.glsl"
layout(location = 0) out vec4 color;

void main() {
  const StoredSurface s = stored_surface();
  if (!s.front) {
    color = vec4(frame.back_color.rgb, 1.0);
    return;
  }
  if (kDark) {
    color = vec4(0.0, 0.0, 0.0, 1.0);
    return;
  }
  shadow_receiver = s.item;
  color = vec4(shade(kForm, s.position, normalize(s.ray), s.normal, s.tangent, s.bitangent, s.weights,
                     items[s.item].form.z, s.shape),
               1.0);
}
