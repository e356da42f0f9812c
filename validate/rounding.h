// How far one form in one scalar lies from the truth, value by value.
#pragma once

#include <type_traits>

#include "validate/exact.h"
#include "validate/numerics.h"

namespace brdf::validate {

// Sums up into a row. T is float (judged by double) or double (judged by 50 digits).
template <class T>
class Rounding {
 public:
  using Truth = std::conditional_t<std::is_same_v<T, float>, double, Exact>;

  explicit Rounding(const Reflectance& form);

  // The parameters of what follows: sets of weights that share a shape.
  void set(const std::vector<std::vector<double>>& weights, const std::vector<double>& shape);
  // The largest |f| of each set for this light, seen from `views`.
  std::vector<double> peaks(const Vec3<double>& wi, const std::vector<Vec3<double>>& views) const;
  // Judges f for the unit vectors next to these. The largest error, over what is stated for its band.
  double judge(const Vec3<double>& wi, const Vec3<double>& wo, const std::vector<double>& peaks);

  const NumericsRow& row() const { return row_; }

 private:
  using Band = double Accuracy::Errors::*;
  struct Judged {
    Band band = nullptr;  // null: too small a value to be judged
    double budget = 0;
    Truth scale{};
    double error = 0;
  };
  // More than a quarter of the body's budget.
  bool noticeable(const Judged& judged, double error) const {
    return judged.band && !(error < numerics_budget(row_.scalar).body / 4);
  }
  bool exceeds_statement(const Judged& judged) const;
  // An error that is noticeable, or more than is stated, of which this much comes from directions that are not quite unit vectors
  // as they are stored.
  bool due_to_storing(const Judged& judged, double storing) const;
  Judged compare(const Vec3<T>& wi, const Vec3<T>& wo, T f, const std::vector<Truth>& truths, std::size_t set,
                 double peak) const;
  double record(const Judged& judged, const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set);
  std::pair<Truth, Truth> range_at_edge(const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set) const;
  Truth scale_of(const Vec3<T>& wi, const Vec3<T>& wo, const std::vector<Truth>& truths, std::size_t set,
                 double peak) const;
  T evaluate(const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set, bool cosine) const;
  void count(T f);
  NumericsRow::Where where(const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set) const;

  Reflectance form_;
  const ReflectanceInfo& info_;
  int diffuse_ = info_.weight_index(Role::diffuse), f0_ = info_.weight_index(Role::f0);
  bool signed_ = info_.violates("non_negative");
  std::vector<std::vector<T>> weights_;
  // Those sets; where there is an f0, then the same at f0 = 1.
  std::vector<std::vector<Truth>> truth_weights_;
  std::vector<T> shape_;
  std::vector<Truth> truth_shape_;
  NumericsRow row_;
};

// The parameters and directions at a point of the unit cube: any of the table, in places where formulas
// break: at grazing angles, on the lobe, next to the light and opposite to it.
struct RoundingCase {
  std::vector<double> weights, shape;
  Vec3<double> wi, wo;
};
std::size_t rounding_dimensions(const ReflectanceInfo& form);
RoundingCase rounding_case(const ReflectanceInfo& form, std::span<const double> point, double least_cosine);

}  // namespace brdf::validate
