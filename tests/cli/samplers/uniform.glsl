// Minnaert's darkening with a rim, sampled uniformly over the hemisphere. Eval and sampler return f cos_i.
//: param kd 0 0.8 0.5
//: param rim 0 0.2 0.1
//: param power 0.2 3 1.4
//: returns f*cos_i
const float kPi = 3.14159265;
float brdf(vec3 L, vec3 V, vec3 N, float kd, float rim, float power) {
  if (L.z <= 0.0 || V.z <= 0.0) return 0.0;
  float darkened = kd / kPi * pow(L.z * V.z, power);
  return (darkened + rim * pow(1.0 - L.z, 3.0) * pow(1.0 - V.z, 3.0)) * L.z;
}
float brdfPdf(vec3 L, vec3 V, vec3 N) { return L.z > 0.0 ? 0.5 / kPi : 0.0; }
float brdfSample(vec2 u, vec3 V, vec3 N, float kd, float rim, float power, out vec3 L, out float pdf) {
  float rho = sqrt(max(1.0 - u.x * u.x, 0.0)), phi = 2.0 * kPi * u.y;
  L = vec3(rho * cos(phi), rho * sin(phi), u.x);
  pdf = brdfPdf(L, V, N);
  return brdf(L, V, N, kd, rim, power);
}
