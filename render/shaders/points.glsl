// The sample points of environment light, the same as in render/light/points.h, which describes them.
uint mixed_bits(uint x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

float[kPointDimensions] point_starts(uvec2 pixel, uint seed) {
  const uint bits = mixed_bits(seed + mixed_bits(pixel.y + mixed_bits(pixel.x)));
  float starts[kPointDimensions];
  for (int d = 0; d < kPointDimensions; ++d)
    starts[d] = float(mixed_bits(bits + uint(d) * 0x9e3779b9u) >> 8) * exp2(-24.0);
  return starts;
}

// In [0, 1); both terms are.
float moved(float start, float by) { return min(fract(start + by), 1.0 - exp2(-24.0)); }
