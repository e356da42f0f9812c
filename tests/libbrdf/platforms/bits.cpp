// Prints hashes of the bits of every form and target: of f_r in double and in float, and of the derivatives.
// Programs for different processors must print the same hashes (platforms_test.py). Albedos follow in full.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "brdf/integrals.h"
#include "brdf/material.h"
#include "brdf/random.h"
#include "brdf/targets.h"

namespace brdf {
namespace {

constexpr std::size_t kPairs = 500;

// FNV-1a of 64 bits (Fowler, Noll and Vo).
class Hash {
 public:
  template <class Bits>
  void add(Bits bits) {
    for (std::size_t k = 0; k < sizeof(Bits); ++k)
      state_ = (state_ ^ ((bits >> (8 * k)) & 0xff)) * 0x100000001b3ull;
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(float x) { add(std::bit_cast<std::uint32_t>(x)); }
  unsigned long long value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ull;
};

// A unit vector of the upper hemisphere by the stereographic projection, which needs no library function.
Vec3<double> random_direction(Random& random) {
  const double u = random.uniform(-0.7, 0.7), v = random.uniform(-0.7, 0.7), s = 1 + u * u + v * v;
  return {2 * u / s, 2 * v / s, (1 - u * u - v * v) / s};
}

Term random_term(const Reflectance& form, Random& random) {
  Term term = make_term(form, 1);
  const auto draw = [&](std::span<const ParameterInfo> infos, std::vector<double>& values) {
    for (std::size_t k = 0; k < infos.size(); ++k)
      values[k] = random.uniform(usual_min(infos[k]), std::min(infos[k].max, infos[k].usual_max));
  };
  draw(info(form).weights, term.weights[0]);
  draw(info(form).shape, term.shape[0]);
  return term;
}

void print_bits(const Reflectance& form, Random& random) {
  Hash doubles, floats, derivatives;
  std::string albedos;
  for (int set = 0; set < 4; ++set) {
    const Term term = random_term(form, random);
    DirectionArrays<double> pairs(kPairs);
    DirectionArrays<float> pairs_in_float(kPairs);
    for (std::size_t i = 0; i < kPairs; ++i) {
      const Vec3<double> wi = random_direction(random), wo = random_direction(random);
      const auto rounded = [](const Vec3<double>& w) {
        return Vec3<float>{float(w.x), float(w.y), float(w.z)};
      };
      pairs.set(i, wi, wo);
      pairs_in_float.set(i, rounded(wi), rounded(wo));
    }
    std::vector<double> f(kPairs);
    std::vector<float> f_in_float(kPairs);
    eval_batch(term, 0, pairs.view(), f.data());
    eval_batch(term, 0, pairs_in_float.view(), f_in_float.data());
    for (const double x : f) doubles.add(x);
    for (const float x : f_in_float) floats.add(x);
    if (info(form).differentiable) {
      const std::size_t rows = 1 + term.shape[0].size() + term.weights[0].size();
      std::vector<double> out(rows * kPairs);
      form->gradient(term.values(0), pairs.view(), {out.data(), kPairs});
      for (const double x : out) derivatives.add(x);
    }
    if (set == 0)
      for (const double theta : {0.0, 35.0, 80.0}) {
        const AlbedoResult result = directional_albedo(term, 0, degrees(theta), degrees(0));
        char text[32];
        std::snprintf(text, sizeof text, " %016llx",
                      static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(result.value)));
        albedos += text;
      }
  }
  std::printf("%s double %016llx float %016llx derivatives %016llx albedo%s\n",
              std::string(info(form).name).c_str(), doubles.value(), floats.value(), derivatives.value(),
              albedos.c_str());
}

}  // namespace
}  // namespace brdf

int main() {
  brdf::Random random(1);
  for (const brdf::Reflectance& form : brdf::catalogue()) brdf::print_bits(form, random);
  for (const brdf::Reflectance& target : brdf::targets()) brdf::print_bits(target, random);
}
