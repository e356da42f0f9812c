#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "rules.glsl"
layout(location = 0) out vec4 color;

void main() {
  const float up = normalize(ray_through(gl_FragCoord.xy)).y;
  color = vec4(0.0);
  for (int c = 0; c < 3; ++c) color[c] = sky_color(frame.background[c], frame.zenith[c], up);
}
