// A coloured diffuse layer and an anisotropic GGX lobe, chosen by the brightest channel.
//: color base 0.8 0.5 0.2
//: param spec 0.05 0.4 0.2
//: param ax 0.15 0.6 0.2
//: param ay 0.15 0.6 0.5
const float kPi = 3.14159265;
float distribution(vec3 h, float ax, float ay) {
  float x = h.x / ax, y = h.y / ay, k = x * x + y * y + h.z * h.z;
  return 1.0 / (kPi * ax * ay * k * k);
}
float lambda(vec3 w, float ax, float ay) {
  float t = (ax * ax * w.x * w.x + ay * ay * w.y * w.y) / (w.z * w.z);
  return 0.5 * (sqrt(1.0 + t) - 1.0);
}
float specularShare(vec3 base, float spec) { return spec / (spec + max(base.x, max(base.y, base.z))); }
vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 base, float spec, float ax, float ay) {
  if (L.z <= 0.0 || V.z <= 0.0) return vec3(0.0);
  vec3 H = normalize(L + V);
  float G = 1.0 / (1.0 + lambda(L, ax, ay) + lambda(V, ax, ay));
  return base / kPi * 0.6 + vec3(spec * distribution(H, ax, ay) * G / (4.0 * L.z * V.z));
}
float brdfPdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 base, float spec, float ax, float ay) {
  if (L.z <= 0.0 || V.z <= 0.0) return 0.0;
  vec3 H = normalize(L + V);
  float p = specularShare(base, spec);
  float lobe = distribution(H, ax, ay) * H.z / (4.0 * dot(V, H));
  return p * lobe + (1.0 - p) * L.z / kPi;
}
vec3 brdfSample(vec3 u, vec3 V, vec3 N, vec3 X, vec3 base, float spec, float ax, float ay, out vec3 L,
                out float pdf) {
  float p = specularShare(base, spec), phi = 2.0 * kPi * u.y;
  pdf = 0.0;
  if (u.z < p) {
    float r = sqrt(u.x / max(1.0 - u.x, 1e-7));
    vec3 H = normalize(vec3(ax * r * cos(phi), ay * r * sin(phi), 1.0));
    L = 2.0 * dot(V, H) * H - V;
  } else {
    L = vec3(sqrt(u.x) * cos(phi), sqrt(u.x) * sin(phi), sqrt(max(1.0 - u.x, 0.0)));
  }
  if (L.z <= 0.0) return vec3(0.0);
  pdf = brdfPdf(L, V, N, X, base, spec, ax, ay);
  return brdf(L, V, N, X, base, spec, ax, ay) * L.z / pdf;
}
