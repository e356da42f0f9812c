// Random directions of a material: a mixture of its terms' own samplers.
#include <algorithm>
#include <cmath>

#include "brdf/geometry.h"
#include "io/error.h"
#include "io/numbers.h"
#include "python/binding.h"

namespace brdf::python {
namespace {

using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

constexpr double kUnitLength = 1e-4;  // by which a squared length may be off

// A term's sampler in the surface's frame. Of shapes per channel the first channel's is followed.
class TermSampler {
 public:
  explicit TermSampler(const Term& term)
      : term_(term), cos_(std::cos(term.tangent_phi.radians())), sin_(std::sin(term.tangent_phi.radians())) {}

  Vec3<double> sample(double u1, double u2, double u3, const Vec3<double>& wo) const {
    return turn(term_.form->sample(term_.shape_of(0), u1, u2, u3, turn(wo, cos_, sin_)), cos_, -sin_);
  }
  double pdf(const Vec3<double>& wi, const Vec3<double>& wo) const {
    return term_.form->pdf(term_.shape_of(0), turn(wi, cos_, sin_), turn(wo, cos_, sin_));
  }

 private:
  const Term& term_;
  double cos_, sin_;
};

// Every term with the same chance.
class Mixture {
 public:
  explicit Mixture(const Material& material) : terms_(material.terms.begin(), material.terms.end()) {}

  // u3 chooses the term, and what is left of it how that samples.
  Vec3<double> sample(const double* u, const Vec3<double>& wo) const {
    const double place = u[2] * double(terms_.size());
    const std::size_t k = std::min(std::size_t(place), terms_.size() - 1);
    return terms_[k].sample(u[0], u[1], place - double(k), wo);
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
    const double square = w.x * w.x + w.y * w.y + w.z * w.z;
    if (!(std::abs(square - 1) <= kUnitLength))
      throw InputError(std::string(name) + ": pair " + std::to_string(k) + ": length " +
                       io::short_number(std::sqrt(square)) + ": must be a unit vector");
  }
}

// wi (n, 3) of wo and u, both (n, 3).
py::array_t<double> sample(const Optics& optics, const Rows& wo, const Rows& u) {
  check_unit(wo, "wo");
  for (py::ssize_t k = 0; k < u.size(); ++k)
    if (!(u.data()[k] >= 0 && u.data()[k] < 1))
      throw InputError("u: " + io::short_number(u.data()[k]) + ": must be from 0 to below 1");
  py::array_t<double> out({wo.shape(0), py::ssize_t{3}});
  const Mixture mixture(optics.file.material);
  const py::ssize_t count = wo.shape(0);
  double* to = out.mutable_data();
  const py::gil_scoped_release unlocked;
  for (py::ssize_t k = 0; k < count; ++k) {
    const Vec3<double> wi = mixture.sample(u.data() + 3 * k, row(wo, k));
    for (const double coordinate : {wi.x, wi.y, wi.z}) *to++ = coordinate;
  }
  return out;
}

py::array_t<double> pdf(const Optics& optics, const Rows& wi, const Rows& wo) {
  check_unit(wi, "wi");
  check_unit(wo, "wo");
  py::array_t<double> out(wo.shape(0));
  const Mixture mixture(optics.file.material);
  const py::ssize_t count = wo.shape(0);
  double* const to = out.mutable_data();
  const py::gil_scoped_release unlocked;
  for (py::ssize_t k = 0; k < count; ++k) to[k] = mixture.pdf(row(wi, k), row(wo, k));
  return out;
}

}  // namespace

void bind_sampling(py::module_& module) {
  module.def("sample", &sample);
  module.def("pdf", &pdf);
}

}  // namespace brdf::python
