// A cosine lobe by rejection from a square: the generator is called until a point lies in the disk.
//: param albedo 0 1 0.6
const float kPi = 3.14159265;
float next(inout uint seed) {
  seed = seed * 747796405u + 2891336453u;
  return float(seed >> 8u) / 16777216.0;
}
float brdf(vec3 L, vec3 V, vec3 N, float albedo) {
  return L.z <= 0.0 || V.z <= 0.0 ? 0.0 : albedo / kPi;
}
float brdfPdf(vec3 L, vec3 V, vec3 N) { return max(L.z, 0.0) / kPi; }
float brdfSample(inout uint seed, vec3 V, vec3 N, float albedo, out vec3 L, out float pdf) {
  vec2 p = vec2(2.0);
  for (int k = 0; k < 8 && dot(p, p) > 1.0; ++k) {
    p.x = 2.0 * next(seed) - 1.0;
    p.y = 2.0 * next(seed) - 1.0;
  }
  pdf = 0.0;
  if (dot(p, p) > 1.0) return 0.0;
  L = vec3(p, sqrt(1.0 - dot(p, p)));
  pdf = L.z / kPi;
  return albedo / kPi;
}
