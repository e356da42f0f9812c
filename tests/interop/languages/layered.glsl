// A diffuse layer under a glossy one, with a sampler and its density. layered.wgsl and layered.slang are the same functions.
//: param base 0 0.8 0.5
//: param coat 0 0.2 0.1
//: param shininess 5 200 40
const float PI = 3.14159265;

float brdf(vec3 L, vec3 V, float base, float coat, float shininess) {
  if (L.z <= 0.0 || V.z <= 0.0) return 0.0;
  vec3 H = normalize(L + V);
  return base / PI + coat * (shininess + 2.0) / (8.0 * PI) * pow(H.z, shininess);
}

float brdfPdf(vec3 L, vec3 V, float shininess) {
  if (L.z <= 0.0 || V.z <= 0.0) return 0.0;
  vec3 H = normalize(L + V);
  float gloss = (shininess + 1.0) / (2.0 * PI) * pow(H.z, shininess);
#ifndef HALF
  gloss /= 4.0 * dot(V, H);
#endif
  return 0.5 * L.z / PI + 0.5 * gloss;
}

vec3 brdfSample(vec3 u, vec3 V, float shininess) {
  float phi = 2.0 * PI * u.y;
  if (u.z < 0.5) {
    float c = pow(1.0 - u.x, 1.0 / (shininess + 1.0));
    float s = sqrt(1.0 - c * c);
    return reflect(-V, vec3(s * cos(phi), s * sin(phi), c));
  }
  return vec3(sqrt(u.x) * cos(phi), sqrt(u.x) * sin(phi), sqrt(1.0 - u.x));
}
