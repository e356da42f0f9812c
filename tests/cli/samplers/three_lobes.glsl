// A diffuse layer and two lobes in the half vector. One number chooses the lobe and is stretched to be used again.
//: param kd 0 0.5 0.3
//: param wide 0 0.3 0.2
//: param narrow 0 0.2 0.1
//: param n 4 30 10
const float kPi = 3.14159265;
float lobe(float cos_h, float exponent) { return (exponent + 1.0) / (2.0 * kPi) * pow(cos_h, exponent); }
float brdf(vec3 L, vec3 V, vec3 N, float kd, float wide, float narrow, float n) {
  if (L.z <= 0.0 || V.z <= 0.0) return 0.0;
  vec3 H = normalize(L + V);
  return kd / kPi + 0.25 * (wide * lobe(H.z, n) + narrow * lobe(H.z, 10.0 * n));
}
float brdfPdf(vec3 L, vec3 V, vec3 N, float n) {
  if (L.z <= 0.0 || V.z <= 0.0) return 0.0;
  vec3 H = normalize(L + V);
  return 0.4 * L.z / kPi + (0.35 * lobe(H.z, n) + 0.25 * lobe(H.z, 10.0 * n)) / (4.0 * dot(V, H));
}
float brdfSample(vec2 u, vec3 V, vec3 N, float kd, float wide, float narrow, float n, out vec3 L, out float pdf) {
  float phi = 2.0 * kPi * u.y;
  pdf = 0.0;
  if (u.x < 0.4) {
    float v = u.x / 0.4;
    L = vec3(sqrt(v) * cos(phi), sqrt(v) * sin(phi), sqrt(1.0 - v));
  } else {
    bool first = u.x < 0.75;
    float v = first ? (u.x - 0.4) / 0.35 : (u.x - 0.75) / 0.25;
    float c = pow(1.0 - min(v, 1.0), 1.0 / ((first ? n : 10.0 * n) + 1.0)), s = sqrt(max(1.0 - c * c, 0.0));
    vec3 H = vec3(s * cos(phi), s * sin(phi), c);
    L = reflect(-V, H);
    if (dot(V, H) <= 0.0) return 0.0;
  }
  if (L.z <= 0.0) return 0.0;
  pdf = brdfPdf(L, V, N, n);
  return brdf(L, V, N, kd, wide, narrow, n);
}
