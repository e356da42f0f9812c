// A diffuse term and a GGX lobe with height-correlated masking: reciprocal, never negative, and energy-conserving if
// kd + ks <= 1.
//: param kd 0 1 0.5
//: param ks 0 1 0.5
//: param f0 0 1 0.04 role f0
//: param roughness 0.1 1 0.4

const float PI = 3.141592653589793;

float slope_density(float cos_h, float alpha) {
  float a2 = alpha * alpha, d = cos_h * cos_h * (a2 - 1.0) + 1.0;
  return a2 / (PI * d * d);
}

// Masking over 4 cos_i cos_o.
float visibility(float cos_i, float cos_o, float alpha) {
  float a2 = alpha * alpha;
  return 0.5 / (cos_o * sqrt(a2 + (1.0 - a2) * cos_i * cos_i) + cos_i * sqrt(a2 + (1.0 - a2) * cos_o * cos_o));
}

float brdf(vec3 L, vec3 V, vec3 N, float kd, float ks, float f0, float roughness) {
  float cos_i = max(dot(N, L), 1e-6), cos_o = max(dot(N, V), 1e-6), alpha = roughness * roughness;
  vec3 H = normalize(L + V);
  float fresnel = f0 + (1.0 - f0) * pow(max(1.0 - dot(L, H), 0.0), 5.0);
  return kd / PI + ks * fresnel * slope_density(dot(N, H), alpha) * visibility(cos_i, cos_o, alpha);
}
