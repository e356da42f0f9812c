#version 460
#extension GL_GOOGLE_include_directive : require
layout(constant_id = 0) const int kBits = 16;
layout(constant_id = 1) const bool kTextured = false;
#include "frame.glsl"
#include "rules.glsl"
#include "surface.glsl"
layout(location = 0) out vec4 out_albedo;
layout(location = 1) out vec4 out_normal;
layout(location = 2) out vec4 out_specular;
layout(location = 3) out vec4 out_position;
layout(location = 4) out vec4 out_roughness;
layout(location = 5) out vec4 out_tangent;
layout(location = 6) out vec4 out_bitangent;

// To the nearest 16-bit float (ties to even), kept in 32 bits: the software driver truncates when it stores.
vec4 to_half(vec4 v) {
  uvec4 bits = floatBitsToUint(v);
  bits = (bits + 0xfffu + ((bits >> 13) & 1u)) & 0xffffe000u;
  return uintBitsToFloat(bits);
}

vec4 stored(vec4 v) { return kBits == 16 ? to_half(v) : v; }
vec4 signed_to_byte(vec3 v, float last) { return vec4(v * 0.5 + 0.5, last); }

void store_bytes(SurfaceHit s, const Item item) {
  const float scale = 1.0 / item.weight_scale.x;
  out_albedo = vec4(s.weights[0] * scale, s.front ? 1.0 : 0.0);
  out_normal = signed_to_byte(s.normal, s.weights[2].r);
  out_specular = vec4(s.weights[1] * scale, 0.0);
  out_position = signed_to_byte(s.relative / item.weights[2].a, float(s.item + 1) / 255.0);
  for (int k = 0; k < 4; ++k) {
    const bool logarithmic = (item.form.y >> k & 1) != 0;
    const float x = logarithmic ? log2(s.shape[k]) : s.shape[k];
    out_roughness[k] = (x - item.shape_low[k]) / (item.shape_high[k] - item.shape_low[k]);
  }
  out_tangent = signed_to_byte(s.tangent, s.weights[2].g);
  out_bitangent = signed_to_byte(s.bitangent, s.weights[2].b);
}

void main() {
  const SurfaceHit s = surface(kTextured);
  if (kBits == 8) {
    store_bytes(s, items[s.item]);
    return;
  }
  out_albedo = stored(vec4(s.weights[0], s.front ? 1.0 : 0.0));
  const bool fourth = (items[s.item].form.y & kFourthShape) != 0;
  out_normal = stored(vec4(s.normal, fourth ? s.shape.a : s.weights[2].r));
  // What rounding took from the normal: a step at the horizon stays in its pixel. Zero with 32 bits.
  const vec3 remainder = (s.normal - out_normal.xyz) * kRemainderScale;
  out_specular = stored(vec4(s.weights[1], dot(remainder, s.tangent)));
  out_position = stored(vec4(s.relative, float(s.item + 1)));
  out_roughness = stored(vec4(s.shape.xyz, dot(remainder, s.bitangent)));
  out_tangent = stored(vec4(s.tangent, s.weights[2].g));
  out_bitangent = stored(vec4(s.bitangent, s.weights[2].b));
}
