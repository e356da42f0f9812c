// Parameters of all kinds, and operations that the languages spell differently. One name is a word of HLSL.
//: color base 0.8 0.2 0.1
//: param rough 0.1 1 0.3
//: param steps 1 5 3
//: param float3 0 1 0.25
//: bool shiny 1
uint mixed(uint bits, int turn) { return (bits ^ (bits >> 3u)) * 747796405u + uint(turn); }

vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 base, float rough, int steps, float float3, bool shiny) {
  vec3 H = normalize(L + V);
  float table[4] = float[4](0.1, 0.2, 0.4, 0.8), sum = 0.0;
  for (int k = 0; k < steps; ++k) sum += pow(max(dot(N, H), 0.0), float(k) + 1.0 / rough) * table[k % 4];
  float rounded = round(3.0 * float3) + roundEven(2.5 * rough) + sign(L.x) + fract(7.0 * sum) + trunc(4.0 * rough);
  float angles = atan(float3) + atan(L.y, L.x + 2.0) + asin(0.3 * rough) + smoothstep(0.1, 0.9, rough) + mod(5.0, rough);
  float noise = float(mixed(uint(steps), -3) & 1023u) / 1023.0 + float(abs(-steps) / 2 + min(steps, 2));
  float power = exp2(-rough) + log2(1.0 + rough) + inversesqrt(rough) + tanh(rough) + step(0.2, float3);
  if (isnan(power) || isinf(sum)) return vec3(0.0);
  return shiny ? base / 3.14 + sum * 0.01 * rounded : base * base * 0.2 + vec3(angles * noise + power);
}
