#include "bench/native_shaders.h"

#include <algorithm>
#include <cmath>

namespace brdf::bench {
namespace {

constexpr float kPi32 = 3.14159265f;

struct Cosines {
  float i, o, h, light_half, light_view;
};

Cosines cosines(const Directions<float>& d, std::size_t k) {
  const float x = d.wi_x[k] + d.wo_x[k], y = d.wi_y[k] + d.wo_y[k], z = d.wi_z[k] + d.wo_z[k];
  const float scale = 1 / std::sqrt(x * x + y * y + z * z);
  return {d.wi_z[k], d.wo_z[k], z * scale, (d.wi_x[k] * x + d.wi_y[k] * y + d.wi_z[k] * z) * scale,
          d.wi_x[k] * d.wo_x[k] + d.wi_y[k] * d.wo_y[k] + d.wi_z[k] * d.wo_z[k]};
}

}  // namespace

void native_sound(const Directions<float>& d, float* out) {
  constexpr float kd = 0.5f, ks = 0.5f, f0 = 0.04f, roughness = 0.4f;
  for (std::size_t k = 0; k < d.count; ++k) {
    const Cosines c = cosines(d, k);
    const float i = std::max(c.i, 1e-6f), o = std::max(c.o, 1e-6f), alpha = roughness * roughness,
                a2 = alpha * alpha;
    const float slope = c.h * c.h * (a2 - 1) + 1;
    const float seen = 0.5f / (o * std::sqrt(a2 + (1 - a2) * i * i) + i * std::sqrt(a2 + (1 - a2) * o * o));
    const float fresnel = f0 + (1 - f0) * std::pow(std::max(1 - c.light_half, 0.0f), 5.0f);
    out[k] = kd / kPi32 + ks * fresnel * a2 / (kPi32 * slope * slope) * seen;
  }
}

void native_clamped_dot(const Directions<float>& d, float* out) {
  constexpr float roughness = 1, color = 1, c1 = 0.5f - 2 / (3 * kPi32), c2 = 2.0f / 3 - 28 / (15 * kPi32);
  const float a = 1 / (1 + c1 * roughness), average = a * (1 + c2 * roughness);
  const auto single = [&](float c) {
    const float sine = std::sqrt(std::max(0.0f, 1 - c * c));
    const float g =
        sine * (std::acos(c) - sine * c) + 2.0f / 3 * ((sine / c) * (1 - sine * sine * sine) - sine);
    return a + roughness * a / kPi32 * g;
  };
  for (std::size_t k = 0; k < d.count; ++k) {
    const Cosines all = cosines(d, k);
    const float i = std::clamp(all.i, 1e-6f, 1.0f), o = std::clamp(all.o, 1e-6f, 1.0f);
    const float s = std::max(all.light_view, 0.0f) - i * o;
    const float once = color * a * (1 + roughness * (s > 0 ? s / std::max(i, o) : s));
    const float often = color * color * average / (1 - color * std::max(0.0f, 1 - average)) *
                        std::max(1e-8f, 1 - single(i)) * std::max(1e-8f, 1 - single(o)) /
                        std::max(1e-8f, 1 - average);
    out[k] = (once + often) / kPi32;
  }
}

void native_wrong_norm(const Directions<float>& d, float* out) {
  constexpr float kd = 0.2f, ks = 0.5f, exponent = 50;
  for (std::size_t k = 0; k < d.count; ++k) {
    const Cosines c = cosines(d, k);
    const float lobe = std::pow(std::max(c.h, 0.0f), exponent) * (exponent + 2) / (2 * kPi32);
    out[k] = kd / kPi32 + ks * lobe / std::max(std::max(c.i, c.o), 1e-6f);
  }
}

}  // namespace brdf::bench
