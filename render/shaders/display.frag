#version 460
// What the window shows: A, B, both, their difference, or the seven targets. Encodes for a UNORM swapchain.
layout(push_constant) uniform Push {
  ivec2 size;      // of the pictures
  int display;     // enum Display
  int tone_map;    // enum ToneMap
  float exposure;
  float split;
  float extent;    // of the largest object: scales the position target
  int bits;        // of the targets
} push;
layout(set = 0, binding = 0) uniform sampler2D pictures[2];
layout(set = 0, binding = 1) uniform sampler2D targets[7];
layout(location = 0) out vec4 color;
const int kSplit = 1, kFlip = 2, kDifference = 3, kGBuffer = 4;
const int kSrgb = 1, kReinhard = 2, kThesis = 3;

vec3 srgb(vec3 c) { return mix(1.055 * pow(max(c, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308))); }

vec3 shown(vec3 linear, int tone_map) {
  const vec3 c = max(linear * exp2(push.exposure), 0.0);
  if (tone_map == kSrgb) return srgb(min(c, 1.0));
  if (tone_map == kReinhard) return srgb(c / (c + 1.0));
  if (tone_map == kThesis) return pow(c / (c + 1.0), vec3(1.0 / 2.2));
  return min(c, 1.0);
}

vec3 false_color(float relative) {
  if (!(relative > 0.0)) return vec3(0.0);
  const float t = clamp(log2(relative) / log2(10.0) + 6.0, 0.0, 6.0) / 2.0;
  const vec3 blue = vec3(0.1, 0.2, 0.8), green = vec3(0.1, 0.7, 0.3), yellow = vec3(0.95, 0.85, 0.1);
  if (t < 1.0) return mix(blue, green, t);
  if (t < 2.0) return mix(green, yellow, t - 1.0);
  return mix(yellow, vec3(0.85, 0.1, 0.1), t - 2.0);
}

// Four columns, two rows; the last place shows the lighting.
vec3 gbuffer(vec2 uv) {
  const ivec2 cell = ivec2(uv * vec2(4.0, 2.0));
  const int k = cell.y * 4 + cell.x;
  const ivec2 pixel = ivec2(fract(uv * vec2(4.0, 2.0)) * vec2(push.size));
  if (k == 7) return shown(texelFetch(pictures[0], pixel, 0).rgb, push.tone_map);
  if (texelFetch(targets[3], pixel, 0).a < 0.5 / 255.0) return vec3(0.0);
  vec3 v = vec3(0.0);
  for (int i = 0; i < 7; ++i) {
    if (i == k) v = texelFetch(targets[i], pixel, 0).rgb;
  }
  const bool direction = k == 1 || k == 5 || k == 6;
  if (push.bits == 8 && (direction || k == 3)) return v;
  if (direction) return v * 0.5 + 0.5;
  if (k == 3) return v / push.extent * 0.5 + 0.5;
  return srgb(clamp(v, 0.0, 1.0));
}

void main() {
  const ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (push.display == kGBuffer) {
    color = vec4(gbuffer(gl_FragCoord.xy / vec2(push.size)), 1.0);
    return;
  }
  const vec4 a = texelFetch(pictures[0], pixel, 0);
  const vec4 b = push.display == 0 ? a : texelFetch(pictures[1], pixel, 0);
  if (push.display == kDifference) {
    const vec3 relative = abs(a.rgb - b.rgb) / max(abs(b.rgb), 1e-6);
    const bool covered = a.a > 0.5 || b.a > 0.5;
    color = vec4(covered ? false_color(max(max(relative.r, relative.g), relative.b)) : vec3(0.0), 1.0);
    return;
  }
  const int border = int(push.split * float(push.size.x));
  const bool show_b = push.display == kFlip || (push.display == kSplit && pixel.x > border);
  color = vec4(shown(show_b ? b.rgb : a.rgb, push.tone_map), 1.0);
  if (push.display == kSplit && pixel.x == border) color = vec4(1.0);
}
