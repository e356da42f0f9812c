#version 460
// Adds a picture through one place of the pixels to the sum over places, and the difference between the halves of its samples.
layout(constant_id = 0) const bool kLit = false;  // by an environment: there are samples
layout(push_constant) uniform Push { float weight, sign; } push;
layout(set = 0, binding = 0) uniform sampler2D drawn[3];  // the picture, the samples' mean, their difference
layout(location = 0) out vec4 sum;
layout(location = 1) out vec4 difference;

void main() {
  const ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 color = texelFetch(drawn[0], pixel, 0);
  if (kLit) color.rgb += texelFetch(drawn[1], pixel, 0).rgb;
  sum = push.weight * color;
  difference = vec4(0.0);
  if (kLit) difference.rgb = push.weight * push.sign * texelFetch(drawn[2], pixel, 0).rgb;
}
