// The surface at a fragment: parameters and frame, with textures applied. C++ counterpart: reference/surface_hit.cpp.
layout(push_constant) uniform Push { int item; } push;
layout(location = 0) in vec3 in_relative;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec2 in_uv;
layout(set = 1, binding = 0) uniform sampler2D maps[4];  // albedo, normal, roughness, metallic

struct SurfaceHit {
  int item;
  bool front;
  vec3 weights[kMostWeights];
  vec4 shape;
  vec3 relative;
  vec3 normal, tangent, bitangent;
};

vec4 bilinear(int slot) {
  const ivec2 size = textureSize(maps[slot], 0);
  const vec2 p = vec2(in_uv.x - floor(in_uv.x), 1.0 - (in_uv.y - floor(in_uv.y))) * vec2(size) - 0.5;
  const vec2 base = floor(p);
  const vec2 t = p - base;
  const ivec2 low = (ivec2(base) + size) % size;
  const ivec2 high = (ivec2(base) + 1) % size;
  const vec4 a = texelFetch(maps[slot], low, 0), b = texelFetch(maps[slot], ivec2(high.x, low.y), 0);
  const vec4 c = texelFetch(maps[slot], ivec2(low.x, high.y), 0), d = texelFetch(maps[slot], high, 0);
  return mix(mix(a, b, t.x), mix(c, d, t.x), t.y);
}

bool has_map(Item item, int slot) { return (item.weight_rules.w >> slot & 1) != 0; }

// The frame about another normal, with the same handedness.
void turn_to(vec3 n, inout SurfaceHit s) {
  const float hand = sign(dot(cross(s.normal, s.tangent), s.bitangent));
  s.tangent = normalize(s.tangent - n * dot(n, s.tangent));
  s.bitangent = cross(n, s.tangent) * hand;
  s.normal = n;
}

vec3 bent_back(vec3 n, vec3 v, float least) { return normalize(n + v * max(least - dot(n, v), 0.0)); }

void apply_maps(const Item item, inout SurfaceHit s) {
  const vec3 albedo = has_map(item, map_albedo) ? bilinear(map_albedo).rgb : weight_at(s.weights, item.form.z);
  const float roughness = has_map(item, map_roughness) ? bilinear(map_roughness).r : 0.0;
  const float metallic = has_map(item, map_metallic) ? bilinear(map_metallic).r : 0.0;
  for (int k = 0; k < kMostWeights; ++k) {
    for (int c = 0; c < 3; ++c) {
      s.weights[k][c] = driven(item.weight_rules[k], s.weights[k][c], albedo[c], roughness, metallic);
    }
  }
  for (int k = 0; k < 4; ++k) s.shape[k] = driven(item.shape_rules[k], s.shape[k], 0.0, roughness, metallic);
  if (has_map(item, map_normal)) {
    const vec3 m = bilinear(map_normal).rgb * 2.0 - 1.0;
    const vec3 n = normalize(s.tangent * m.x + s.bitangent * m.y + s.normal * m.z);
    const vec3 v = normalize(frame.camera.xyz - (item.model[3].xyz + s.relative));
    turn_to(bent_back(n, v, kLeastFacing), s);
  }
}

SurfaceHit surface(bool textured) {
  const Item item = items[push.item];
  SurfaceHit s;
  s.item = push.item;
  s.front = gl_FrontFacing;
  for (int k = 0; k < kMostWeights; ++k) s.weights[k] = item.weights[k].rgb;
  s.shape = item.shape;
  s.relative = in_relative;
  s.normal = normalize(in_normal);
  s.tangent = normalize(in_tangent.xyz - s.normal * dot(s.normal, in_tangent.xyz));
  s.bitangent = cross(s.normal, s.tangent) * (in_tangent.w < 0.0 ? -1.0 : 1.0);
  if (textured) apply_maps(item, s);
  const vec3 v = normalize(frame.camera.xyz - (item.model[3].xyz + s.relative));
  if (s.front && dot(s.normal, v) < kLeastSeen) turn_to(bent_back(s.normal, v, kLeastSeen), s);
  const float c = item.weights[0].a, turn = item.weights[1].a;
  const vec3 t = s.tangent;
  s.tangent = t * c + s.bitangent * turn;
  s.bitangent = s.bitangent * c - t * turn;
  return s;
}
