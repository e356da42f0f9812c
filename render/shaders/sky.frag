#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
layout(location = 0) out vec4 color;

void main() {
  const vec3 ray = normalize(ray_through(gl_FragCoord.xy));
  color = vec4(mix(frame.background.rgb, frame.zenith.rgb, sqrt(max(ray.y, 0.0))), 0.0);
}
