// The share of the light with a shadow that reaches a surface. The reference traces one ray.
layout(set = 0, binding = 2) uniform sampler2D shadow_map;  // how near to the light its first surface is (0: none), whose

// The item that is shaded. An object casts no shadow on itself.
int shadow_receiver = -1;

// Percentage closer filtering (Reeves, Salesin and Cook 1987) over 3 x 3 texels round the place, each interpolated.
float lit_share(int light, vec3 position) {
  if (light != int(frame.shadow.x)) return 1.0;
  const vec3 p = (frame.shadow_projection * vec4(position, 1.0)).xyz;
  const float size = frame.shadow.y;
  const vec2 at = (p.xy * vec2(0.5, -0.5) + 0.5) * size - 0.5;
  if (any(lessThan(at, vec2(1.0))) || any(greaterThan(at, vec2(size - 3.0)))) return 1.0;  // outside the map
  const vec2 base = floor(at), t = at - base;
  const vec4 across = vec4(1.0 - t.x, 1.0, 1.0, t.x), down = vec4(1.0 - t.y, 1.0, 1.0, t.y);
  const int own = shadow_receiver % int(frame.shadow.z);
  float share = 0.0;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const vec2 first = texelFetch(shadow_map, ivec2(base) + ivec2(i - 1, j - 1), 0).rg;
      if (first.r <= p.z || int(first.g) == own) share += across[i] * down[j];
    }
  }
  return share / 9.0;
}
