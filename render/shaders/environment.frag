#version 460
#extension GL_GOOGLE_include_directive : require
// One run of points of environment light for every pixel of a form: the mean over the run. See
// reference/environment_light.h for what is drawn and how it is weighted.
// Or the smooth picture: the lights and the environment's light in one pass, which reads the targets once.
layout(constant_id = 0) const int kForm = 0;
layout(constant_id = 1) const int kBits = 16;
// Instead of a run: few directions, the same in every pixel. Each takes the light's mean over its share.
layout(constant_id = 2) const bool kSmooth = false;
layout(constant_id = 3) const bool kSingle = false;  // as in lighting.frag
#include "frame.glsl"
#include "points.glsl"
#include "brdf.glsl"
#include "samplers.glsl"
#include "shade.glsl"
#include "stored_surface.glsl"
#include "rules.glsl"
#include "light.glsl"
layout(set = 3, binding = 0) uniform sampler2D points_towards;  // of light_points.frag
layout(set = 3, binding = 1) uniform sampler2D points_radiance;
layout(location = 0) out vec4 color;
layout(location = 1) out vec4 difference;  // of a run: render/gpu/place_sums.h

// Azimuth and polar angle in units of the picture, each in [0, 1]. In the first quadrant, by the kernel: the
// device's own arctangents are coarser than a large picture's texels.
vec2 place_towards(vec3 w) {
  const float azimuth = brdf_angle(abs(w.x), abs(w.z));  // from the z axis
  const float phi = (w.z < 0.0 ? azimuth : kPi - azimuth) * (w.x < 0.0 ? -1.0 : 1.0);
  const float polar = brdf_angle(sqrt(w.x * w.x + w.z * w.z), abs(w.y));
  const float theta = w.y < 0.0 ? kPi - polar : polar;
  return vec2(phi / (2.0 * kPi) + 0.5, theta / kPi);
}
vec4 texel_towards(vec3 w) {
  const ivec2 size = textureSize(light_texels, 0);
  const ivec2 at = ivec2(place_towards(w) * vec2(size));
  return texelFetch(light_texels, clamp(at, ivec2(0), size - 1), 0);
}

vec3 blurred_at(vec2 place, int level) {
  const vec2 size = vec2(2 * kBlurredHeight >> level, kBlurredHeight >> level);
  const float row = float(2 * kBlurredHeight - (2 * kBlurredHeight >> level) + 2 * level);
  const vec2 at = vec2(1.0, 1.0 + row) + place * size;
  return textureLod(light_blurred, at / vec2(textureSize(light_blurred, 0)), 0.0).rgb;
}
// The light averaged over about this solid angle.
vec3 blurred_towards(vec3 w, float solid_angle) {
  const float texel = 2.0 * kPi / float(kBlurredHeight * kBlurredHeight);  // of the finest level, on average
  const float level = clamp(0.5 * log2(solid_angle / texel), 0.0, float(kBlurredLevels - 1));
  const int finer = min(int(level), kBlurredLevels - 2);
  const vec2 place = place_towards(w);
  return mix(blurred_at(place, finer), blurred_at(place, finer + 1), level - float(finer));
}

// The points of brdf_sample(): the first half follows the lobe, the second half the cosine. A single point of a
// half is near the middle of its distribution; two points lie opposite each other at its median.
vec3 smooth_light(StoredSurface s, mat3 basis, vec3 wo) {
  vec3 sum = vec3(0.0);
  const int points = 2 * push.count;
  for (int k = 0; k < points; ++k) {
    const float radius = push.count == 1 ? 0.02 : 0.5, turn = 0.125 + 0.5 * float(k % push.count);
    const vec3 wi = brdf_sample(kForm, vec3(radius, turn, k < push.count ? 0.25 : 0.75), wo, s.shape);
    const float density = brdf_pdf(kForm, wi, wo, s.shape);
    if (!(wi.z > 0.0 && density > 0.0)) continue;
    const vec3 value = brdf_eval_cos(kForm, wi, wo, s.shape, s.weights[0], s.weights[1], s.weights[2]);
    const float share = 1.0 / (float(points) * density);  // of the sphere
    const float reaching = floor_share(s.position, basis * wi);
    sum += value * blurred_towards(to_picture(basis * wi), share) * (reaching * share);
  }
  return sum;
}

void main() {
  const StoredSurface s = stored_surface();
  if (!s.front) {
    if (!kSmooth) discard;
    color = vec4(frame.back_color.rgb, 1.0);
    return;
  }
  const mat3 basis = mat3(s.tangent, s.bitangent, s.normal);
  const vec3 wo = -normalize(s.ray) * basis;
  if (kSmooth) {
    shadow_receiver = s.item;
    const vec3 direct = shade(kForm, s.position, normalize(s.ray), s.normal, s.tangent, s.bitangent, s.weights,
                              items[s.item].form.z, s.shape);
    color = vec4(direct + smooth_light(s, basis, wo) * frame.environment.z, 1.0);
    return;
  }
  const uvec2 pixel = uvec2(gl_FragCoord.xy), place = light_place(pixel);
  const uint bits = pixel_bits(pixel);
  const int half_run = (push.count + 1) / 2;
  vec3 sum = vec3(0.0), first_half = vec3(0.0);
  for (int k = 0; k < push.count; ++k) {
    for (int own = 0; own < 2; ++own) {
      vec4 texel;
      vec3 wi;
      if (own == 0) {
        const ivec2 at = ivec2(place) + ivec2(0, k * kLightSquare);
        const vec4 towards = texelFetch(points_towards, at, 0);
        wi = towards.xyz * basis;
        texel = vec4(texelFetch(points_radiance, at, 0).rgb, towards.a);
      } else {
        wi = brdf_sample(kForm, vec3(point(bits, 2, k), point(bits, 3, k), point(bits, 4, k)), wo, s.shape);
        texel = texel_towards(to_picture(basis * wi));
      }
      const float density = texel.a + brdf_pdf(kForm, wi, wo, s.shape);
      const vec3 value = brdf_eval_cos(kForm, wi, wo, s.shape, s.weights[0], s.weights[1], s.weights[2]);
      if (wi.z > 0.0 && density > 0.0) sum += value * texel.rgb * (floor_share(s.position, basis * wi) / density);
    }
    if (k + 1 == half_run) first_half = sum;
  }
  const float share = frame.environment.z / float(push.count);
  color = vec4(sum * share, 0.0);
  difference = vec4((2.0 * first_half - sum) * share, 0.0);
}
