// GGX by visible normals, as caps of the sphere (Dupuy and Benyoub 2023). The sampler returns the weight.
//: param alpha 0.1 1 0.4
//: param f0 0 1 0.6
static const float kPi = 3.14159265;
float distribution(float cos_h, float alpha) {
  float d = cos_h * cos_h * (alpha * alpha - 1) + 1;
  return alpha * alpha / (kPi * d * d);
}
float lambda(float c, float alpha) { return 0.5 * (sqrt(1 + alpha * alpha * (1 - c * c) / (c * c)) - 1); }
float fresnel(float f0, float c) { return f0 + (1 - f0) * pow(1 - saturate(c), 5); }
float brdf(float3 L, float3 V, float3 N, float alpha, float f0) {
  if (L.z <= 0 || V.z <= 0) return 0;
  float3 H = normalize(L + V);
  float masking = 1 / (1 + lambda(L.z, alpha) + lambda(V.z, alpha));
  return distribution(H.z, alpha) * masking * fresnel(f0, dot(L, H)) / (4 * L.z * V.z);
}
float brdfPdf(float3 L, float3 V, float3 N, float alpha) {
  if (L.z <= 0 || V.z <= 0) return 0;
  float3 H = normalize(L + V);
  return distribution(H.z, alpha) / (1 + lambda(V.z, alpha)) / (4 * V.z);
}
float brdfSample(float2 u, float3 V, float3 N, float alpha, float f0, out float3 L, out float pdf) {
  float3 stretched = normalize(float3(alpha * V.x, alpha * V.y, V.z));
  float z = (1 - u.y) * (1 + stretched.z) - stretched.z, rho = sqrt(saturate(1 - z * z)), phi = 2 * kPi * u.x;
  float3 cap = float3(rho * cos(phi), rho * sin(phi), z) + stretched;
  float3 H = normalize(float3(alpha * cap.x, alpha * cap.y, cap.z));
  L = reflect(-V, H);
  pdf = brdfPdf(L, V, N, alpha);
  if (pdf <= 0) return 0;
  return fresnel(f0, dot(V, H)) * (1 + lambda(V.z, alpha)) / (1 + lambda(L.z, alpha) + lambda(V.z, alpha));
}
