// The integrand: f_r cos of the channels (or lobes) of one form, with one direction fixed.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "brdf/integrals.h"
#include "brdf/quadrature.h"

namespace brdf::integrals {

using quadrature::gauss_legendre;
using quadrature::gauss_lobatto;
using quadrature::GaussRule;
using quadrature::graded_panel;
using quadrature::kRow;
using quadrature::sinh_cosh;
using quadrature::unit_node;
using quadrature::UnitNode;

// Regions of fast variation. The widths are the parameters with that role; the width of a form without such
// parameters is measured at normal incidence. The kink is the one that the form declares.
struct Features {
  double width_x = 1, width_y = 1;  // of the lobe, in the half vector's slope
  bool root_at_horizon = false;     // f cos behaves as sqrt(cos) there
  bool mirror_lobe = false;         // about the mirror direction, not about the half vector
  bool is_polynomial = false;       // of both directions: without any lobe
  // Apart from constants, the integrand is negligible beyond kReach widths. This holds for an exponential
  // tail, which the rules cut off at that distance.
  bool compact = false;
  Kink kink = Kink::none;
  bool oriented = false;  // depends on the tangent without having two widths
  bool anisotropic() const { return oriented || width_x != width_y; }
  // Returns true if the slopes of the half vector are suitable variables.
  bool about_half_vector() const {
    return !mirror_lobe && !is_polynomial && kink != Kink::azimuth && kink != Kink::mirror_edge;
  }
};

// exp(-kReach^2) = 9e-27.
inline constexpr double kReach = 7.745966692414834;
inline constexpr double kLeastWidth = 1e-5;  // a lobe is never assumed to be narrower

// The fixed direction. It is given by its elevation, not its polar angle, for accuracy near grazing.
struct FixedDirection {
  double elevation, phi;
};
inline constexpr double kGrazing = 1e-11;  // elevations below this are treated as the limit

class Integrand {
 public:
  static constexpr std::size_t kBlock = 256;  // directions per evaluation

  // Integrates channels of a term that have the same shape.
  Integrand(const Term& term, std::vector<std::size_t> channels, Fixed fixed);
  // Integrates the lobes of a linear form.
  Integrand(const Reflectance& form, std::span<const double> shape, Fixed fixed);

  const Features& features() const { return features_; }
  std::size_t columns() const { return columns_; }  // integrals computed together
  std::size_t outputs() const { return lobes_only_ ? columns_ : channels_.size(); }
  // Returns the outputs, computed from the integrals of the columns over the hemisphere. The integral of a
  // constant column is exactly pi times its value.
  std::vector<double> combine(std::span<const double> columns) const;
  // Return the same in two parts, for rules that sum the hemisphere piece by piece: the contribution of the
  // varying columns to a piece, and the contribution of the constant columns to the whole.
  std::vector<double> combine_varying(std::span<const double> columns) const;
  std::vector<double> constant_outputs() const;
  // Returns the outputs, computed from the integrals of the columns over any region.
  std::vector<double> weigh(std::vector<double> columns) const;

  // Computes f cos of column c at n <= kBlock moving unit directions: out[c n + j]. `fixed` is given in the
  // frame of the tangent. Uses the batches of the forms.
  void evaluate(const Vec3<double>& fixed, std::size_t n, const double* x, const double* y, const double* z,
                double* out) const;

 private:
  Reflectance form_;
  std::vector<double> shape_;
  std::vector<std::vector<double>> weights_;  // of the channels, then of the first channel
  std::vector<std::size_t> channels_;
  Fixed fixed_;
  bool lobes_only_ = false;
  std::size_t columns_ = 0;
  std::vector<double> constants_;  // of the constant columns; NaN for the others
  Features features_;

  void look();
  double sum_at(const Vec3<double>& fixed, const Vec3<double>& moving) const;
  void find_constants();
  double measured_width() const;
  bool measured_root() const;
  bool measured_orientation() const;
};

// Returns the channels of a term in groups that have the same shape and are integrated together.
std::vector<std::vector<std::size_t>> groups_of_one_shape(const Term& term);

// Collects weighted directions and sums the integrand over them, one block at a time.
class NodeSum {
 public:
  NodeSum(const Integrand& integrand, const Vec3<double>& fixed)
      : integrand_(integrand),
        fixed_(fixed),
        out_(kBlock * integrand.columns()),
        sums_(integrand.columns(), 0.0) {}

  void add(double x, double y, double z, double weight) {
    x_[used_] = x;
    y_[used_] = y;
    z_[used_] = z;
    weight_[used_] = weight;
    if (++used_ == kBlock) flush();
  }
  // Adds the nodes of a block that is the only source of this sum.
  void add(std::size_t count, const double* x, const double* y, const double* z, const double* weight) {
    std::copy_n(x, count, x_.begin());
    std::copy_n(y, count, y_.begin());
    std::copy_n(z, count, z_.begin());
    std::copy_n(weight, count, weight_.begin());
    used_ = count;
    flush();
  }
  const std::vector<double>& sums() {
    flush();
    return sums_;
  }
  long evaluations() const { return evaluations_ + long(used_); }

 private:
  static constexpr std::size_t kBlock = Integrand::kBlock;
  void flush();
  template <std::size_t N>
  void add_columns(std::size_t first);

  const Integrand& integrand_;
  Vec3<double> fixed_;
  std::array<double, kBlock> x_, y_, z_, weight_;
  std::size_t used_ = 0;
  long evaluations_ = 0;
  std::vector<double> out_, sums_;
};

struct Sums {
  std::vector<double> columns;
  long evaluations;
  // e-folds of distance that the points of the longest panel cover; 0 for rules that do not use it.
  double folds = 0;
};

// Compute the integrals with n points per panel and dimension.
Sums pole_rule(const Integrand& integrand, const FixedDirection& fixed, int n);
Sums slope_rule(const Integrand& integrand, const FixedDirection& fixed, int n);

// Returns the largest relative error that rounding may cause in a sum of so many evaluations.
double rounding_of(const Integrand& integrand, const FixedDirection& fixed, long evaluations);

// Return one result per output.
std::vector<AlbedoResult> adaptive_rule(const Integrand& integrand, const FixedDirection& fixed,
                                        double tolerance, long max_evaluations);
std::vector<AlbedoResult> integrate(const Integrand& integrand, const FixedDirection& fixed,
                                    const AlbedoOptions& options);

}  // namespace brdf::integrals
