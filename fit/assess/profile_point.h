// One point of a parameter's profile.
#pragma once

#include <atomic>
#include <span>
#include <vector>

#include "fit/algebra/eigen_view.h"
#include "fit/assess/reported.h"
#include "fit/solve/minima.h"

namespace brdf::fit {

// A point of the profile: the parameter on the scale of its interval, and by which the cost is above its
// minimum there.
struct ProfilePoint {
  double x = 0, rise = 0;
  std::vector<double> p;  // the solver's parameters
};

// A reported parameter, or a product of two, on the scale of its interval: the solver's where it has one.
class ProfileCoordinate {
 public:
  // `r`: number `index` of the reported parameters; it is referred to.
  ProfileCoordinate(const Model& model, const Reported& r, std::size_t index);

  // Of the slot that is held, or kNoSlot: then the value is reached by a penalty.
  std::size_t slot() const { return slot_; }
  double low() const;
  double high() const;
  double at(std::span<const double> p) const;
  // With the gradient by the solver's parameters.
  std::pair<double, Eigen::VectorXd> with_gradient(std::span<const double> p) const;

 private:
  Reported there(std::span<const double> p) const;
  double on_scale(double value) const;

  const Model& model_;
  const Reported& r_;
  std::size_t index_, slot_;
};

// Minimises the cost over all parameters within their bounds while one coordinate has a value.
class ProfileSolver {
 public:
  // `level`: the rise that is looked for; costs are minimised to a thousandth of it.
  ProfileSolver(const SampleStream& stream, const Minimum& minimum, const ProfileCoordinate& coordinate,
                double level, const std::atomic<bool>* interrupted);

  // The least cost near x from one start; the shapes may be held as the start has them. What is returned is a
  // point that was evaluated: where the minimisation stops early its rise is that of its own parameters, not
  // less.
  ProfilePoint least_at(double x, std::vector<double> start, bool hold_shapes = false) const;

 private:
  const SampleStream& stream_;
  const Minimum& minimum_;
  const ProfileCoordinate& coordinate_;
  double level_, origin_;
  const std::atomic<bool>* interrupted_;
  std::vector<double> low_, high_;
};

}  // namespace brdf::fit
