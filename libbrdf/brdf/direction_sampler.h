// A sampler of directions and its density that somebody else wrote for a reflectance: a shader's functions,
// or functions of the caller. Code that judges them knows them only through this interface.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "brdf/names.h"

namespace brdf {

// The quantity that a sampler returns with a direction; cos_i is the cosine of the sampled direction.
enum class SampleValue { f, f_cos_i, weight };
// The measure of a density: solid angle of the sampled direction, projected solid angle, or solid angle of
// the half vector.
enum class DensityOf { solid_angle, projected, half };

template <>
inline constexpr std::array<std::string_view, 3> kNames<SampleValue>{"f", "f*cos_i", "f*cos_i/pdf"};
template <>
inline constexpr std::array<std::string_view, 3> kNames<DensityOf>{"solid_angle", "projected", "half"};

// One result of a sampler.
struct Draw {
  static constexpr std::size_t kMostValues = 4;
  Vec3<double> wi;    // the sampled direction, as returned
  double pdf = 0;     // 1/sr of the sampled direction; NaN if the sampler returns no density
  bool valid = true;  // the truth value that the sampler returns
  // The values that the sampler returns, in the order of SamplerFacts::values, each with three components.
  std::array<std::array<double, 3>, kMostValues> values{};
  std::size_t used = 0;  // random numbers that this draw used
};

struct SamplerFacts {
  // A value that the sampler returns; `kind` if the file or the name states the quantity.
  struct Value {
    std::string name;
    std::optional<SampleValue> kind = {};
  };
  bool draws = false;        // draw() is available
  bool gives_pdf = false;    // draw() returns a density
  bool has_density = false;  // density() is available
  std::vector<Value> values = {};
  std::size_t randoms = 0;  // numbers in [0, 1) that a draw takes
  bool in_float = true;     // `single` is obeyed; otherwise all results are in double
  bool generated = false;   // draws use different counts of them
  bool has_eval = true;     // values of f are available
  // Names of the functions, for messages; pdf_name is the name of the density that draw() returns.
  std::string sampler_name = "sample", density_name = "pdf", pdf_name = "pdf", eval_name = "eval";
  SampleValue eval_returns = SampleValue::f;
  std::vector<std::size_t> colour_weights = {};  // weights that are one number per channel
  std::vector<std::string> missing = {};         // reasons why a function is not available
  // Clauses on an absent function.
  std::string no_sampler = "the file has no sampler that is understood",
              no_density = "the file has no density function that is understood",
              no_eval = "the file has no reflectance";
  // The declaration of the quantity that the sampler returns, without the name of the quantity.
  std::string before_quantity = "a line `//: sample returns ", after_quantity = "`";
  // The reason why draws in float do not show all that a device may compute; empty: they do.
  std::string half_unknown = {};
};

// Returns the density of a measure, at a direction wi for the viewer wo, per solid angle of wi in 1/sr.
inline double per_solid_angle(DensityOf measure, double density, const Vec3<double>& wi,
                              const Vec3<double>& wo) {
  if (measure == DensityOf::projected) return density * std::abs(wi.z);
  if (measure == DensityOf::solid_angle) return density;
  const Vec3<double> sum{wi.x + wo.x, wi.y + wo.y, wi.z + wo.z};
  const double length = std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
  return density / (4 * std::abs(sum.x * wo.x + sum.y * wo.y + sum.z * wo.z) / length);
}

class DirectionSampler {
 public:
  virtual ~DirectionSampler() = default;
  virtual const SamplerFacts& facts() const = 0;
  // Draws out.size() directions for the unit direction wo. `u`: facts().randoms numbers for each. `single`:
  // in float. Throws InputError if the code cannot be evaluated.
  virtual void draw(const Material& at, const Vec3<double>& wo, std::span<const double> u, bool single,
                    std::span<Draw> out) const = 0;
  // Writes the density of each direction per solid angle, 1/sr.
  virtual void density(const Material& at, const Vec3<double>& wo, std::span<const Vec3<double>> wi,
                       bool single, std::span<double> out) const = 0;
};

}  // namespace brdf
