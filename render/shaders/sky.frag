#version 460
#extension GL_GOOGLE_include_directive : require
layout(push_constant) uniform Push { vec2 pixel_to_ndc; } push;
#include "frame.glsl"
layout(location = 0) out vec4 color;

void main() {
  const vec2 ndc = gl_FragCoord.xy * push.pixel_to_ndc * vec2(1.0, -1.0) + vec2(-1.0, 1.0);
  const vec3 ray = normalize(frame.forward.xyz + frame.right.xyz * ndc.x + frame.up.xyz * ndc.y);
  color = vec4(mix(frame.background.rgb, frame.zenith.rgb, sqrt(max(ray.y, 0.0))), 0.0);
}
