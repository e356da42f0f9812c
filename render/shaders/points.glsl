// The sample points of environment light, the same as in render/light/points.h, which describes them.
layout(push_constant) uniform Push {
  int item;  // the only item if kSingle
  uint seed;
  int count;  // of a run; smooth: half the number of directions
  float first[kPointDimensions];  // how far each coordinate has moved before this run
  float step[kPointDimensions];   // how far each coordinate moves from one point of this run to the next
} push;

uint mixed_bits(uint x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}
uint pixel_bits(uvec2 pixel) { return mixed_bits(push.seed + mixed_bits(pixel.y + mixed_bits(pixel.x))); }

uvec2 light_place(uvec2 pixel) {
  const uint shift = pixel_bits(pixel / kLightSquare);
  return (pixel + uvec2(shift, shift >> 16)) % kLightSquare;
}

// A coordinate of the k-th point of this run, in [0, 1); both terms are.
float point(uint bits, int d, int k) {
  const float start = float(mixed_bits(bits + uint(d) * 0x9e3779b9u) >> 8) * exp2(-24.0);
  return min(fract(start + fract(push.first[d] + push.step[d] * float(k))), 1.0 - exp2(-24.0));
}
