#include "shadow.glsl"
// Direct light on a surface seen along the unit vector `view`: sum over lights of f_r cos_i E, plus ambient times the
// diffuse weight.
vec3 to_local(vec3 w, vec3 t, vec3 b, vec3 n) { return vec3(dot(w, t), dot(w, b), dot(w, n)); }

vec3 shade(int form, vec3 position, vec3 view, vec3 n, vec3 t, vec3 b, vec3 w[kMostWeights], int diffuse, vec4 shape) {
  const vec3 wo = to_local(-view, t, b, n);
  vec3 sum = frame.ambient.rgb * weight_at(w, diffuse);
  for (int k = 0; k < frame.counts.x; ++k) {
    const Light light = frame.lights[k];
    const vec3 to_light = light.vector.xyz - position * light.vector.w;
    const float d2 = dot(to_light, to_light);
    const vec3 wi = to_local(to_light * inversesqrt(d2), t, b, n);
    const vec3 irradiance = light.vector.w == 0.0 ? light.irradiance.rgb : light.irradiance.rgb / d2;
    sum += irradiance * lit_share(k, position) * brdf_eval_cos(form, wi, wo, shape, w[0], w[1], w[2]);
  }
  return sum;
}
