// A diffuse layer under a glossy coat, with a sampler for path tracers. The sampler's density has a fault that
// docs/howto/sampler.md finds; the macro REPAIRED repairs it. With COAT_ALONE every sample comes from the coat.
//: param base 0 0.8 0.5
//: param coat 0 0.2 0.1
//: param shininess 5 200 40
const float PI = 3.14159265;

float brdf(vec3 L, vec3 V, vec3 N, float base, float coat, float shininess) {
  if (L.z <= 0.0 || V.z <= 0.0) return 0.0;
  vec3 H = normalize(L + V);
  return base / PI + coat * (shininess + 2.0) / (8.0 * PI) * pow(H.z, shininess);
}

float brdfPdf(vec3 L, vec3 V, vec3 N, float shininess) {
  if (L.z <= 0.0 || V.z <= 0.0) return 0.0;
  vec3 H = normalize(L + V);
  float coat = (shininess + 1.0) / (2.0 * PI) * pow(H.z, shininess);
#ifdef REPAIRED
  coat /= 4.0 * dot(V, H);
#endif
#ifdef COAT_ALONE
  return coat;
#endif
  return 0.5 * L.z / PI + 0.5 * coat;
}

vec3 brdfSample(vec3 u, vec3 V, vec3 N, float shininess, out float pdf) {
  float phi = 2.0 * PI * u.y;
  vec3 L = vec3(sqrt(u.x) * cos(phi), sqrt(u.x) * sin(phi), sqrt(1.0 - u.x));
#ifdef COAT_ALONE
  u.z = 0.0;
#endif
  if (u.z < 0.5) {
    float c = pow(1.0 - u.x, 1.0 / (shininess + 1.0)), s = sqrt(1.0 - c * c);
    L = reflect(-V, vec3(s * cos(phi), s * sin(phi), c));
  }
  pdf = brdfPdf(L, V, N, shininess);
  return L;
}
