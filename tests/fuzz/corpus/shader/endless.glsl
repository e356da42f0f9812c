float brdf(vec3 L, vec3 V, vec3 N) {
  float s = 0.0;
  while (s >= 0.0) s += 1.0;
  return s;
}
