// Random directions of a material, from a mixture of its terms' own samplers.
#include <algorithm>
#include <cmath>

#include "brdf/geometry.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "python/batches.h"
#include "python/binding.h"

namespace brdf::python {
namespace {

using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

// One of `count` choices selected by a number in [0, 1), and the remainder of this number, rescaled to [0,
// 1).
struct Chosen {
  std::size_t place;
  double rest;
};
Chosen choose(double u, std::size_t count) {
  const double at = u * double(count);
  const std::size_t place = std::min(std::size_t(at), count - 1);
  return {place, at - double(place)};
}

// The sampler of a term in the surface's frame. If the channels have separate shapes, each shape is chosen
// with the same probability.
class TermSampler {
 public:
  explicit TermSampler(const Term& term)
      : term_(term), cos_(std::cos(term.tangent_phi.radians())), sin_(std::sin(term.tangent_phi.radians())) {}

  Vec3<double> sample(double u1, double u2, double u3, const Vec3<double>& wo) const {
    const auto [channel, rest] = choose(u3, term_.shape.size());
    return turn(term_.form->sample(term_.shape[channel], u1, u2, rest, turn(wo, cos_, sin_)), cos_, -sin_);
  }
  double pdf(const Vec3<double>& wi, const Vec3<double>& wo) const {
    const Vec3<double> i = turn(wi, cos_, sin_), o = turn(wo, cos_, sin_);
    double sum = 0;
    for (const std::vector<double>& shape : term_.shape) sum += term_.form->pdf(shape, i, o);
    return sum / double(term_.shape.size());
  }

 private:
  const Term& term_;
  double cos_, sin_;
};

// A mixture in which every term has the same probability.
class Mixture {
 public:
  explicit Mixture(const Material& material) : terms_(material.terms.begin(), material.terms.end()) {}

  // Samples a direction. u3 selects the term, and the remainder of u3 is passed to the term's sampler.
  Vec3<double> sample(const double* u, const Vec3<double>& wo) const {
    const auto [k, rest] = choose(u[2], terms_.size());
    return terms_[k].sample(u[0], u[1], rest, wo);
  }
  double pdf(const Vec3<double>& wi, const Vec3<double>& wo) const {
    double sum = 0;
    for (const TermSampler& term : terms_) sum += term.pdf(wi, wo);
    return sum / double(terms_.size());
  }

 private:
  std::vector<TermSampler> terms_;
};

Vec3<double> row(const Rows& rows, py::ssize_t k) {
  const double* const w = rows.data() + 3 * k;
  return {w[0], w[1], w[2]};
}

void check_unit(const Rows& rows, const char* name) {
  for (py::ssize_t k = 0; k < rows.shape(0); ++k) {
    const Vec3<double> w = row(rows, k);
    if (!(std::abs(w.x * w.x + w.y * w.y + w.z * w.z - 1) <= kUnitLength))
      refuse_direction(name, std::size_t(k), w.x, w.y, w.z);
  }
}

// Returns directions wi (n, 3) for wo and u, both (n, 3).
py::array_t<double> sample(const Optics& optics, const Rows& wo, const Rows& u) {
  py::array_t<double> out({wo.shape(0), py::ssize_t{3}});
  const Mixture mixture(optics.file.material);
  const py::ssize_t count = wo.shape(0);
  double* to = out.mutable_data();
  const py::gil_scoped_release unlocked;
  check_unit(wo, "wo");
  for (py::ssize_t k = 0; k < u.size(); ++k)
    if (!(u.data()[k] >= 0 && u.data()[k] < 1))
      throw InputError("u: pair " + std::to_string(k / 3) + ": " + io::short_number(u.data()[k], 17) +
                       ": must be from 0 to below 1");
  for (py::ssize_t k = 0; k < count; ++k) {
    const Vec3<double> wi = mixture.sample(u.data() + 3 * k, row(wo, k));
    for (const double coordinate : {wi.x, wi.y, wi.z}) *to++ = coordinate;
  }
  return out;
}

py::array_t<double> pdf(const Optics& optics, const Rows& wi, const Rows& wo) {
  py::array_t<double> out(wo.shape(0));
  const Mixture mixture(optics.file.material);
  const py::ssize_t count = wo.shape(0);
  double* const to = out.mutable_data();
  const py::gil_scoped_release unlocked;
  check_unit(wi, "wi");
  check_unit(wo, "wo");
  for (py::ssize_t k = 0; k < count; ++k) to[k] = mixture.pdf(row(wi, k), row(wo, k));
  return out;
}

}  // namespace

void bind_sampling(py::module_& module) {
  module.def("sample", &sample);
  module.def("pdf", &pdf);
}

}  // namespace brdf::python
