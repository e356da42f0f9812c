#include "validate/joint/weights.h"

#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"

namespace brdf::validate {

void Moments::add(double weight) {
  if (count_ == 0) first_ = smallest_ = largest_ = weight;
  const double x = weight - first_;
  sum_ += x, sum2_ += x * x, sum3_ += x * x * x;
  smallest_ = std::min(smallest_, weight);
  largest_ = std::max(largest_, weight);
  ++count_;
}

double Moments::variance() const {
  return std::max(sum2_ / double(count_) - shifted() * shifted(), 0.0);
}

double Moments::error() const {
  return std::sqrt(variance() / double(count_));
}

double Moments::skewness() const {
  const double m = shifted(), v = variance();
  // The third moment of weights that are equal to rounding is rounding.
  if (!(v > 1e-12 * mean() * mean())) return 0;
  return (sum3_ / double(count_) - 3 * m * v - m * m * m) / std::pow(v, 1.5);
}

void Weights::add(const Trio& trio, const Quantities& quantities, std::span<const double> u,
                  std::span<const Draw> draws) {
  const SamplerFacts& facts = trio.facts();
  const bool has_pdf = facts.has_density || facts.gives_pdf;
  const std::size_t own = facts.values.size();  // the weight is f cos_i / pdf of the reflectance
  std::size_t from = own;
  for (std::size_t j = own; j-- > 0;)
    if (quantities.of[j] == SampleValue::weight || has_pdf) from = j;
  if (from == own && !(has_pdf && facts.has_eval)) return;
  std::vector<Vec3<double>> wi;
  for (const Draw& draw : draws) wi.push_back(draw.wi.z > 0 ? draw.wi : Vec3<double>{0, 0, 1});
  std::vector<double> f, density;
  if (from == own) f = trio.f(wi, true);
  if (!facts.gives_pdf && facts.has_density) density = trio.density(wi);
  for (std::size_t k = 0; k < draws.size(); ++k) {
    const Draw& draw = draws[k];
    const double pdf = facts.gives_pdf ? draw.pdf : density.empty() ? std::nan("") : density[k];
    const bool lost = !draw.valid || pdf <= 0 || !(draw.wi.z > 0);
    bool all_finite = true;
    for (std::size_t c = 0; c < of_.size(); ++c) {
      const SampleValue kind = from == own ? SampleValue::f_cos_i : quantities.of[from];
      const double value = from == own ? f[c * wi.size() + k] : draw.values[from][c];
      double weight = 0;
      if (!lost && kind == SampleValue::weight)
        weight = value;
      else if (!lost)
        weight = value * (kind == SampleValue::f ? draw.wi.z : 1) / pdf;
      if (std::isfinite(weight)) {
        of_[c].add(weight);
        continue;
      }
      all_finite = false;
      if (reason_.empty())
        reason_ =
            std::string(name_of(kind)) + " of " + (from == own ? facts.eval_name : facts.sampler_name) +
            " is " + io::short_number(value) +
            (kind == SampleValue::weight ? "" : ", with a density of " + io::short_number(pdf) + " /sr");
    }
    not_finite_.add(!all_finite, 0, draw.wi, u.subspan(k * facts.randoms, facts.randoms));
  }
}

}  // namespace brdf::validate
