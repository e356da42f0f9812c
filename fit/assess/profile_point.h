// One point of a parameter's profile.
#pragma once

#include <atomic>
#include <span>
#include <vector>

#include "fit/algebra/eigen_view.h"
#include "fit/assess/reported.h"
#include "fit/solve/minima.h"

namespace brdf::fit {

// A point of the profile. `x` is the parameter on the scale of its interval; `rise` is the cost there minus
// the minimum cost.
struct ProfilePoint {
  double x = 0, rise = 0;
  std::vector<double> p;  // the solver's parameters
};

// A reported parameter, or a product of two, on the scale of its interval. This is the solver's scale if
// the parameter has one.
class ProfileCoordinate {
 public:
  // `r` is number `index` of the reported parameters; it must outlive this object.
  ProfileCoordinate(const Model& model, const Reported& r, std::size_t index);

  // Returns the slot that is held, or kNoSlot if the value is reached by a penalty.
  std::size_t slot() const { return slot_; }
  // Return the limits of the coordinate.
  double low() const;
  double high() const;
  // Returns the coordinate at the solver's parameters p.
  double at(std::span<const double> p) const;
  // Returns the value and its gradient by the solver's parameters.
  std::pair<double, Eigen::VectorXd> with_gradient(std::span<const double> p) const;

 private:
  Reported there(std::span<const double> p) const;
  double on_scale(double value) const;

  const Model& model_;
  const Reported& r_;
  std::size_t index_, slot_;
};

// Minimises the cost over all parameters within their bounds while one coordinate is held at a value.
class ProfileSolver {
 public:
  // `level` is the rise of interest; costs are minimised to a thousandth of it.
  ProfileSolver(const SampleStream& stream, const Minimum& minimum, const ProfileCoordinate& coordinate,
                double level, const std::atomic<bool>* interrupted);

  // Returns the least cost near x from one start. `hold_shapes` holds the shapes at their starting values.
  // The returned point was evaluated: if the minimisation stops early, the rise is the actual rise of the
  // returned parameters.
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
