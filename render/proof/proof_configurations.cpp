#include <algorithm>
#include <cmath>
#include <random>

#include "brdf/directions.h"
#include "brdf/random.h"
#include "io/files/error.h"
#include "render/gpu/reflectance_glsl.h"
#include "render/proof/shader_proof.h"

namespace brdf::render {
namespace {

using Engine = std::mt19937_64;

double uniform(Engine& random, double low, double high) {
  return low + (high - low) * uniform01(random);
}
double log_uniform(Engine& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

std::array<float, 4> rounded(const Vec3<double>& w) {
  return {float(w.x), float(w.y), float(w.z), 0};
}

float random_value(Engine& random, const ParameterInfo& p) {
  if (p.whole) return float(std::min(std::floor(uniform(random, p.min, p.usual_max + 1)), p.usual_max));
  if (!p.log_scale) return float(uniform(random, usual_min(p), p.usual_max));
  return float(log_uniform(random, p.min > 0 ? p.min : 1e-3, p.max));
}

void set_directions(Engine& random, ProofConfiguration& c) {
  const bool grazing = random() % 5 == 0;
  const double below = random() % 16 == 0 ? -1 : 1;
  const double theta_i =
      grazing ? kPi / 2 - below * log_uniform(random, 1e-8, 1e-2) : uniform(random, 0, kPi / 2);
  const double phi_i = uniform(random, 0, 2 * kPi);
  c.wi = rounded(direction(radians(theta_i), radians(phi_i)));
  if (random() % 2 == 0) {  // near the mirror direction, at all distances
    const double distance = log_uniform(random, 1e-6, 1);
    c.wo = rounded(direction(radians(theta_i + uniform(random, -distance, distance)),
                             radians(phi_i + kPi + uniform(random, -distance, distance))));
  } else {
    c.wo = rounded(direction(radians(uniform(random, 0, kPi / 2)), radians(uniform(random, 0, 2 * kPi))));
  }
  if (random() % 2 == 0) std::swap(c.wi, c.wo);
}

std::vector<std::array<float, 4>> extreme_directions() {
  const float subnormal = 1e-40f, tiny = 1e-30f;
  std::vector<std::array<float, 4>> w{
      {0, 0, 1},         {1, 0, 0},          {-1, 0, 0},        {0, 1, 0},         {0, -1, 0},
      {0, 0, -1},        {1, 0, -0.0f},      {1, subnormal, 0}, {subnormal, 0, 1}, {subnormal, -subnormal, 1},
      {1, 0, subnormal}, {1, 0, -subnormal}, {-1, tiny, tiny},  {tiny, 1, tiny}};
  for (double theta : {1e-4, 0.7, 1.5, 1.5707, 1.5707962, 1.5708, 2.0})
    for (double phi : {0.0, 0.8, kPi, 0.8 + kPi})
      w.push_back(rounded(direction(radians(theta), radians(phi))));
  return w;
}

// Throws InputError if the form has more parameters than a configuration holds.
void require_room(const Reflectance& form) {
  const ProofConfiguration room;
  if (info(form).weights.size() > room.weights.size() || info(form).shape.size() > room.shape.size())
    throw InputError(std::string(info(form).name) + " " + shader_obstacle(info(form)));
}

}  // namespace

std::vector<ProofConfiguration> random_configurations(const Reflectance& form, std::size_t count,
                                                      std::uint64_t seed) {
  require_room(form);
  Engine random(seed * 1000003 + std::uint64_t(catalogue_index(form)));
  const ReflectanceInfo& about = info(form);
  std::vector<ProofConfiguration> configurations(count);
  for (ProofConfiguration& c : configurations) {
    set_directions(random, c);
    for (std::size_t k = 0; k < about.shape.size(); ++k) c.shape[k] = random_value(random, about.shape[k]);
    for (std::size_t k = 0; k < about.weights.size(); ++k)
      for (std::size_t channel = 0; channel < 3; ++channel)
        c.weights[k][channel] = random_value(random, about.weights[k]);
  }
  return configurations;
}

std::vector<ProofConfiguration> extreme_configurations(const Reflectance& form) {
  require_room(form);
  const ReflectanceInfo& about = info(form);
  std::size_t corners = 1;
  for (std::size_t k = 0; k < about.shape.size(); ++k) corners *= 3;
  std::vector<ProofConfiguration> configurations;
  for (std::size_t corner = 0; corner < corners; ++corner) {
    ProofConfiguration c;
    std::size_t rest = corner;
    for (std::size_t k = 0; k < about.shape.size(); ++k, rest /= 3) {
      const ParameterInfo& p = about.shape[k];
      c.shape[k] = float(rest % 3 == 0 ? p.min : rest % 3 == 1 ? p.max : p.initial);
    }
    for (std::size_t k = 0; k < about.weights.size(); ++k) {
      const ParameterInfo& p = about.weights[k];
      c.weights[k] = {float(usual_min(p)), float(p.usual_max), float(p.initial)};
    }
    for (const auto& wi : extreme_directions()) {
      c.wi = wi;
      c.wo = {-wi[0], -wi[1], -wi[2]};  // wi = wo is among the pairs below
      configurations.push_back(c);
      for (const auto& wo : extreme_directions()) {
        c.wo = wo;
        configurations.push_back(c);
      }
    }
  }
  return configurations;
}

}  // namespace brdf::render
