// How far one value of a form lies from the truth.
#pragma once

#include <vector>

#include "validate/numerics/exact.h"
#include "validate/numerics/extended.h"
#include "validate/numerics/numerics.h"

namespace brdf::validate {

using Band = double Accuracy::Errors::*;

// One value's error relative to what it is judged by, see NumericsRow.
struct Deviation {
  Band band = nullptr;  // null: too small a value to be judged
  double error = 0;
  bool as_stored = false;  // the truth is that of the vectors as they stand
};

// Compares values of T with those of Truth.
template <class T, class Truth>
class Deviations {
 public:
  explicit Deviations(const Reflectance& form);

  // As Rounding's.
  void set(const std::vector<std::vector<T>>& weights, const std::vector<T>& shape);
  // Of the values f, one per set of weights; those that are not finite are not judged.
  std::vector<Deviation> of(const Vec3<T>& wi, const Vec3<T>& wo, const std::vector<T>& f,
                            const std::vector<double>& peaks) const;

 private:
  struct Judged {
    Deviation deviation;
    Truth scale{};
  };
  // More than a quarter of the body's budget.
  bool noticeable(const Judged& judged, double error) const;
  bool exceeds_statement(const Judged& judged) const;
  // An error that is noticeable, or more than is stated, of which this much comes from directions that are
  // not quite unit vectors as they are stored.
  bool due_to_storing(const Judged& judged, double storing) const;
  std::vector<Truth> truths(const Vec3<Truth>& wi, const Vec3<Truth>& wo) const;
  Judged compare(const Vec3<T>& wi, const Vec3<T>& wo, T f, const std::vector<Truth>& truths, std::size_t set,
                 double peak) const;
  std::pair<Truth, Truth> range_at_edge(const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set) const;
  Truth scale_of(const Vec3<T>& wi, const Vec3<T>& wo, const std::vector<Truth>& truths, std::size_t set,
                 double peak) const;

  Reflectance form_;
  const ReflectanceInfo& info_;
  int diffuse_ = info_.weight_index(Role::diffuse), f0_ = info_.weight_index(Role::f0);
  bool signed_ = info_.violates("non_negative");
  Accuracy::Errors budget_;
  std::optional<Accuracy::Errors> stated_;
  std::size_t sets_ = 0;
  // The sets; where there is an f0, then the same at f0 = 1.
  std::vector<std::vector<Truth>> weights_;
  std::vector<Truth> shape_;
};

// What the form's header states for T.
template <class T>
std::optional<Accuracy::Errors> stated_accuracy(const ReflectanceInfo& form);

}  // namespace brdf::validate
