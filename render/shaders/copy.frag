#version 460
#extension GL_GOOGLE_include_directive : require
#include "layout.glsl"
// Copies the seven targets: what a pass over them costs at least.
layout(set = 0, binding = 0) uniform sampler2D targets[kTargetCount];
layout(location = 0) out vec4 out0;
layout(location = 1) out vec4 out1;
layout(location = 2) out vec4 out2;
layout(location = 3) out vec4 out3;
layout(location = 4) out vec4 out4;
layout(location = 5) out vec4 out5;
layout(location = 6) out vec4 out6;

void main() {
  const ivec2 pixel = ivec2(gl_FragCoord.xy);
  out0 = texelFetch(targets[0], pixel, 0);
  out1 = texelFetch(targets[1], pixel, 0);
  out2 = texelFetch(targets[2], pixel, 0);
  out3 = texelFetch(targets[3], pixel, 0);
  out4 = texelFetch(targets[4], pixel, 0);
  out5 = texelFetch(targets[5], pixel, 0);
  out6 = texelFetch(targets[6], pixel, 0);
}
