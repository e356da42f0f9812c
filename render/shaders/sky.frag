#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "rules.glsl"
layout(location = 0) out vec4 color;

void main() {
  const vec3 ray = ray_through(gl_FragCoord.xy);
  const float up = normalize(ray).y;
  const float height = dot(ray, frame.up.xyz) / dot(frame.up.xyz, frame.up.xyz);
  color = vec4(0.0);
  for (int c = 0; c < 3; ++c) {
    color[c] = frame.counts.y == kBackdrop ? backdrop_color(frame.background[c], frame.zenith[c], height)
                                           : sky_color(frame.background[c], frame.zenith[c], up);
  }
}
