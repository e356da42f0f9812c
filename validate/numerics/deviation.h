// The deviation of one value of a form from the truth.
#pragma once

#include <vector>

#include "validate/numerics/exact.h"
#include "validate/numerics/extended.h"
#include "validate/numerics/numerics.h"

namespace brdf::validate {

using Band = double Accuracy::Errors::*;

// The error of one value, relative to the scale that NumericsRow defines.
struct Deviation {
  Band band = nullptr;  // null: the value is too small to be judged
  double error = 0;
  bool as_stored = false;  // the truth is evaluated at the stored vectors, without normalising them
};

// Compares values in T with values in Truth.
template <class T, class Truth>
class Deviations {
 public:
  explicit Deviations(const Reflectance& form);

  // Sets the parameters, as Rounding::set() does.
  void set(const std::vector<std::vector<T>>& weights, const std::vector<T>& shape);
  // Returns the deviations of the values f, one per set of weights. Values that are not finite are not
  // judged.
  std::vector<Deviation> of(const Vec3<T>& wi, const Vec3<T>& wo, const std::vector<T>& f,
                            const std::vector<double>& peaks) const;

 private:
  struct Judged {
    Deviation deviation;
    Truth scale{};
  };
  // Returns whether the error is more than a quarter of the body's budget.
  bool noticeable(const Judged& judged, double error) const;
  bool exceeds_statement(const Judged& judged) const;
  // Returns whether the error is noticeable, or exceeds the stated error, and is due to the fact that the
  // stored directions are not exactly unit vectors. `storing`: the error that this fact causes.
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
  // The sets of weights; if the form has an f0, followed by the same sets with f0 = 1.
  std::vector<std::vector<Truth>> weights_;
  std::vector<Truth> shape_;
};

// The accuracy that the form's header states for T; std::nullopt if it states no accuracy.
template <class T>
std::optional<Accuracy::Errors> stated_accuracy(const ReflectanceInfo& form);

}  // namespace brdf::validate
