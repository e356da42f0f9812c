#version 460
#extension GL_GOOGLE_include_directive : require
#include "layout.glsl"
#include "rules.glsl"
// What the window shows: A, B, both, their difference, or the seven targets. Encodes for a UNORM swapchain.
// One pipeline per way to show and tone map: a uniform branch would evaluate all of them.
layout(constant_id = 0) const int kDisplay = 0;      // enum Display
layout(constant_id = 1) const int kToneMap = 0;      // enum ToneMap
layout(constant_id = 2) const int kDitherTile = 32;  // thresholds across: as a constant it divides fast
layout(push_constant) uniform Push {
  ivec2 size;      // of the pictures
  ivec2 origin;    // in the window, of what is shown
  ivec2 place;     // its size there; that of the pictures, except for the targets
  float gain;      // 2^exposure
  float split;
  float extent;    // of the largest object: scales the position target
  int bits;        // of the targets
  int plus_minus;  // the difference on a signed scale
} push;
layout(set = 0, binding = 0) uniform sampler2D pictures[2];
layout(set = 0, binding = 1) uniform sampler2D targets[kTargetCount];
layout(set = 0, binding = 2) uniform sampler2D dither;  // thresholds, as picture/dither.h has them
layout(location = 0) out vec4 color;

vec3 shown(vec3 linear) { return tone_curve(kToneMap, linear * push.gain); }

// To a whole byte, as the picture's file has it.
vec3 dithered(vec3 value) {
  const float threshold = texelFetch(dither, (ivec2(gl_FragCoord.xy) - push.origin) % kDitherTile, 0).r;
  precise const vec3 scaled = clamp(value, 0.0, 1.0) * 255.0 + 1.0 - threshold;
  return floor(scaled) / 255.0;
}

// Three columns and three rows, whose places have the picture's aspect; after the targets the lighting, then nothing.
vec3 gbuffer(vec2 uv) {
  const ivec2 cell = ivec2(uv * 3.0);
  const int k = cell.y * 3 + cell.x;
  const ivec2 pixel = ivec2(fract(uv * 3.0) * vec2(push.size));
  if (k > kTargetCount) return vec3(0.1);
  if (k == kTargetCount) return shown(texelFetch(pictures[0], pixel, 0).rgb);
  if (texelFetch(targets[target_position], pixel, 0).a < 0.5 / 255.0) return vec3(0.0);
  vec3 v = vec3(0.0);
  for (int i = 0; i < kTargetCount; ++i) {
    if (i == k) v = texelFetch(targets[i], pixel, 0).rgb;
  }
  const bool direction = k == target_normal || k == target_tangent || k == target_bitangent;
  if (push.bits == 8 && (direction || k == target_position)) return v;
  if (direction) return v * 0.5 + 0.5;
  if (k == target_position) return v / push.extent * 0.5 + 0.5;
  return tone_curve(tone_map_srgb, v);
}

void main() {
  const vec2 at = gl_FragCoord.xy - vec2(push.origin);  // in what is shown
  if (kDisplay == display_gbuffer) {
    color = vec4(gbuffer(at / vec2(push.place)), 1.0);
    return;
  }
  const ivec2 pixel = ivec2(at);
  // Where nobody measured (picture.h: kNotMeasured), as io/page/hatching.h.
  const bool dark = (pixel.x + pixel.y) % kHatchPeriod < kHatchPeriod / 2;
  const vec3 hatching = vec3(float(dark ? kHatchDark : kHatchBright) / 255.0);
  const vec4 a = texelFetch(pictures[0], pixel, 0);
  const vec4 b = kDisplay == display_picture ? a : texelFetch(pictures[1], pixel, 0);
  if (kDisplay == display_difference) {
    const vec3 relative = (a.rgb - b.rgb) / max(abs(b.rgb), 1e-6), size = abs(relative);
    const float most = max(max(size.r, size.g), size.b);
    const float worst = size.r == most ? relative.r : size.g == most ? relative.g : relative.b;
    const bool lit = any(notEqual(a.rgb, vec3(0.0))) || any(notEqual(b.rgb, vec3(0.0)));
    const bool covered = lit && (a.a > 0.5 || b.a > 0.5), known = b.a < 0.5 || b.a > 0.9;
    const vec3 scale = push.plus_minus != 0 ? signed_color(worst) : false_color(most);
    color = vec4(covered ? known ? scale : hatching : vec3(0.0), 1.0);
    return;
  }
  const int border = int(push.split * float(push.size.x));
  const bool show_b = kDisplay == display_flip || (kDisplay == display_split && pixel.x > border);
  color = vec4(dithered(shown(show_b ? b.rgb : a.rgb)), 1.0);
  if (show_b && b.a > 0.5 && b.a < 0.9) color = vec4(hatching, 1.0);
  if (kDisplay == display_split && pixel.x == border) color = vec4(1.0);
}
