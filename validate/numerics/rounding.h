// Measures, value by value, how far one form in one scalar deviates from the truth.
#pragma once

#include <type_traits>

#include "validate/numerics/deviation.h"

namespace brdf::validate {

// Accumulates the errors into a row. T is float (judged by double) or double (judged by 50 digits).
template <class T>
class Rounding {
 public:
  explicit Rounding(const Reflectance& form);

  // Sets the parameters for the following calls: sets of weights that share a shape.
  void set(const std::vector<std::vector<double>>& weights, const std::vector<double>& shape);
  // Returns the largest |f| of each set for this light, seen from `views`.
  std::vector<double> peaks(const Vec3<double>& wi, const std::vector<Vec3<double>>& views) const;
  // Judges f for the unit vectors nearest to these. Returns the largest error, divided by the stated error
  // of its band, or by the budget if no error is stated.
  double judge(const Vec3<double>& wi, const Vec3<double>& wo, const std::vector<double>& peaks);

  const NumericsRow& row() const { return row_; }

 private:
  using Truth = std::conditional_t<std::is_same_v<T, float>, double, Exact>;
  // 50 digits are slow. Only values that may exceed the errors so far are judged with 50 digits.
  using FirstLook = std::conditional_t<std::is_same_v<T, double> && kExtendedIsFiner, Extended, Truth>;

  bool perhaps_a_record(const Deviation& d) const;
  void keep(const Deviation& d, const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set);
  T evaluate(const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set, bool cosine) const;
  void count(T f);
  NumericsRow::Where where(const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set) const;

  Reflectance form_;
  const ReflectanceInfo& info_;
  Deviations<T, FirstLook> first_;
  Deviations<T, Truth> exact_;
  std::vector<std::vector<T>> weights_;
  std::vector<T> shape_;
  NumericsRow row_;
};

// The parameters and directions of one case.
struct RoundingCase {
  std::vector<double> weights, shape;
  Vec3<double> wi, wo;
};
// Returns the number of coordinates of a point of rounding_case().
std::size_t rounding_dimensions(const ReflectanceInfo& form);
// Returns the case at a point of the unit cube. The parameters take any values of the table. The directions
// include places where formulas break: at grazing angles, on the lobe, next to the light and opposite to
// the light.
RoundingCase rounding_case(const ReflectanceInfo& form, std::span<const double> point, double least_cosine);

}  // namespace brdf::validate
