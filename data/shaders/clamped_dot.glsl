// Fujii's Oren-Nayar with compensation of multiple reflections (EON, Portsmouth et al. 2024). The dot product of the
// directions is clamped by mistake, so the shader violates energy conservation at grazing angles.
//: param roughness 0 1 1
//: color color 1 1 1

const float PI = 3.141592653589793;
const float C1 = 0.5 - 2.0 / (3.0 * PI);
const float C2 = 2.0 / 3.0 - 28.0 / (15.0 * PI);

float single_albedo(float c, float roughness) {
  float a = 1.0 / (1.0 + C1 * roughness), sine = sqrt(max(0.0, 1.0 - c * c));
  float g = sine * (acos(c) - sine * c) + 2.0 / 3.0 * ((sine / c) * (1.0 - sine * sine * sine) - sine);
  return a + roughness * a / PI * g;
}

vec3 brdf(vec3 L, vec3 V, vec3 N, float roughness, vec3 color) {
  float cos_i = clamp(dot(N, L), 1e-6, 1.0), cos_o = clamp(dot(N, V), 1e-6, 1.0);
  float s = max(dot(L, V), 0.0) - cos_i * cos_o;  // the error: dot(L, V) may be negative
  float a = 1.0 / (1.0 + C1 * roughness), average = a * (1.0 + C2 * roughness);
  vec3 once = color * a * (1.0 + roughness * (s > 0.0 ? s / max(cos_i, cos_o) : s));
  vec3 often = color * color * average / (1.0 - color * max(0.0, 1.0 - average)) * max(1e-8, 1.0 - single_albedo(cos_i, roughness)) *
               max(1e-8, 1.0 - single_albedo(cos_o, roughness)) / max(1e-8, 1.0 - average);
  return (once + often) / PI;
}
