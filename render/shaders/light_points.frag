#version 460
#extension GL_GOOGLE_include_directive : require
// One run of points of environment light that follow the light, for each place of the squares of pixels that share them: the
// k-th point is kLightSquare k rows below the first.
#include "frame.glsl"
#include "points.glsl"
#include "rules.glsl"
#include "light.glsl"
layout(set = 2, binding = 1) uniform sampler2D light_columns;  // ends of the cells of each row
layout(set = 2, binding = 2) uniform sampler2D light_rows;
layout(location = 0) out vec4 towards;   // direction in the world, and its density per solid angle
layout(location = 1) out vec4 radiance;

// The first cell with an end above u.
int cell_of_row(float u, int count) {
  int low = 0, high = count - 1;
  while (low < high) {
    const int middle = (low + high) >> 1;
    if (u < texelFetch(light_rows, ivec2(0, middle), 0).r) high = middle; else low = middle + 1;
  }
  return low;
}
int cell_of_column(float u, int row, int count) {
  int low = 0, high = count - 1;
  while (low < high) {
    const int middle = (low + high) >> 1;
    if (u < texelFetch(light_columns, ivec2(middle, row), 0).r) high = middle; else low = middle + 1;
  }
  return low;
}

// The position of u between the two ends of its cell.
float within(float u, float low, float high) { return clamp((u - low) / max(high - low, 1e-30), 0.0, 1.0); }

// A direction of the picture; `texel` is the radiance from this direction.
vec3 light_sample(float u1, float u2, out vec4 texel) {
  const ivec2 size = textureSize(light_texels, 0);
  const int y = cell_of_row(u1, size.y);
  const int x = cell_of_column(u2, y, size.x);
  const float top = y > 0 ? texelFetch(light_rows, ivec2(0, y - 1), 0).r : 0.0;
  const float left = x > 0 ? texelFetch(light_columns, ivec2(x - 1, y), 0).r : 0.0;
  const float down = within(u1, top, texelFetch(light_rows, ivec2(0, y), 0).r);
  const float across = (float(x) + within(u2, left, texelFetch(light_columns, ivec2(x, y), 0).r)) / float(size.x);
  texel = texelFetch(light_texels, ivec2(x, y), 0);
  // Uniform in the cosine. Half angles are used because near the poles the cosine has too few digits for the sine.
  const float upper = sin(kPi * 0.5 * float(y) / float(size.y)), lower = sin(kPi * 0.5 * float(y + 1) / float(size.y));
  const float half_sine2 = mix(upper * upper, lower * lower, down);
  const float cosine = 1.0 - 2.0 * half_sine2, sine = 2.0 * sqrt(half_sine2 * max(1.0 - half_sine2, 0.0));
  const float phi = 2.0 * kPi * (across - 0.5);
  return vec3(sine * sin(phi), cosine, -sine * cos(phi));
}

void main() {
  const uvec2 at = uvec2(gl_FragCoord.xy);
  const int k = int(at.y / kLightSquare);
  const uint bits = pixel_bits(uvec2(at.x, at.y % kLightSquare));
  vec4 texel;
  const vec3 w = from_picture(light_sample(point(bits, 0, k), point(bits, 1, k), texel));
  towards = vec4(w, texel.a);
  radiance = vec4(texel.rgb, 0.0);
}
