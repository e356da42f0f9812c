// The picture of the environment and the distributions for sampling its directions: render/light/light_map.h.
layout(set = 2, binding = 0) uniform sampler2D light_texels;   // rgb: radiance, a: density per solid angle
layout(set = 2, binding = 1) uniform sampler2D light_columns;  // ends of the cells of each row
layout(set = 2, binding = 2) uniform sampler2D light_rows;
layout(set = 2, binding = 3) uniform sampler2D light_blurred;  // all levels: render/light/blurred_light.h
const float kPi = 3.14159265358979;

vec3 to_picture(vec3 w) {
  const vec4 e = frame.environment;
  return vec3(e.x * w.x - e.y * w.z, w.y, e.y * w.x + e.x * w.z);
}
vec3 from_picture(vec3 w) {
  const vec4 e = frame.environment;
  return vec3(e.x * w.x + e.y * w.z, w.y, e.x * w.z - e.y * w.x);
}

// The share of the environment's radiance from the direction w (in the world) that reaches the point p: below the horizon,
// the light that reaches the floor next to the objects, which are taken as balls. render/scene/floor.h is the same.
float floor_share(vec3 p, vec3 w) {
  const float floor_height = frame.environment.w;
  if (w.y >= 0.0 || floor_height <= kNoFloor) return 1.0;
  const vec3 place = p + w * (max(p.y - floor_height, 0.0) / max(-w.y, 1e-4));
  float share = 1.0;
  for (int k = 0; k < int(frame.shadow.z); ++k) {
    const vec3 centre = items[k].model[3].xyz;
    const vec2 apart = place.xz - centre.xz;
    const float radius = items[k].weights[2].a;
    share *= light_beside_ball(max(centre.y - floor_height, radius), radius, dot(apart, apart));
  }
  return share;
}

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
