#version 460
#extension GL_GOOGLE_include_directive : require
// One run of points of environment light for every pixel of a form: the mean over the run. See
// reference/environment_light.h for what is drawn and how it is weighted.
layout(constant_id = 0) const int kForm = 0;
layout(constant_id = 1) const int kBits = 16;
#include "frame.glsl"
layout(push_constant) uniform Push {
  int item;  // unused here: stored_surface.glsl
  uint seed;
  int count;
  float first[kPointDimensions];  // how far each coordinate has moved before this run
} push;
#include "brdf.glsl"
#include "samplers.glsl"
const bool kSingle = false;
#include "stored_surface.glsl"
#include "points.glsl"
#include "rules.glsl"
#include "light.glsl"
layout(location = 0) out vec4 color;

// In the first quadrant, by the kernel: the device's own arctangents are coarser than a large picture's texels.
vec4 texel_towards(vec3 w) {
  const ivec2 size = textureSize(light_texels, 0);
  const float azimuth = brdf_angle(abs(w.x), abs(w.z));  // from the z axis
  const float phi = (w.z < 0.0 ? azimuth : kPi - azimuth) * (w.x < 0.0 ? -1.0 : 1.0);
  const float polar = brdf_angle(sqrt(w.x * w.x + w.z * w.z), abs(w.y));
  const float theta = w.y < 0.0 ? kPi - polar : polar;
  const ivec2 at = ivec2(vec2(phi / (2.0 * kPi) + 0.5, theta / kPi) * vec2(size));
  return texelFetch(light_texels, clamp(at, ivec2(0), size - 1), 0);
}

void main() {
  const StoredSurface s = stored_surface();
  if (!s.front) discard;
  const mat3 basis = mat3(s.tangent, s.bitangent, s.normal);
  const vec3 wo = -normalize(s.ray) * basis;
  const float starts[kPointDimensions] = point_starts(uvec2(gl_FragCoord.xy), push.seed);
  vec3 sum = vec3(0.0);
  for (int k = 0; k < push.count; ++k) {
    float u[kPointDimensions];
    for (int d = 0; d < kPointDimensions; ++d) u[d] = moved(starts[d], fract(push.first[d] + kPointSteps[d] * float(k)));
    for (int own = 0; own < 2; ++own) {
      vec4 texel;
      vec3 wi;
      if (own == 0) {
        wi = from_picture(light_sample(u[0], u[1], texel)) * basis;
      } else {
        wi = brdf_sample(kForm, vec3(u[2], u[3], u[4]), wo, s.shape);
        texel = texel_towards(to_picture(basis * wi));
      }
      const float density = texel.a + brdf_pdf(kForm, wi, wo, s.shape);
      const vec3 value = brdf_eval_cos(kForm, wi, wo, s.shape, s.weights[0], s.weights[1], s.weights[2]);
      if (wi.z > 0.0 && density > 0.0) sum += value * texel.rgb * (floor_share(s.position, basis * wi) / density);
    }
  }
  color = vec4(sum * (frame.environment.z / float(push.count)), 0.0);
}
