// The parameters as they are reported, as functions of the solver's parameters with their gradients.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fit/assess/result.h"
#include "fit/model/model.h"

namespace brdf::fit {

// A reported parameter as a function of the solver's parameters: its value, and its gradient by the slots.
struct Reported {
  Estimate estimate;
  const ParameterInfo* info = nullptr;  // never null once reported
  std::vector<std::pair<std::size_t, double>> gradient;
  std::size_t slot = kNoSlot;  // the slot of a shape parameter
  // For any shape parameter: a slot with a scale on which the interval is symmetric.
  std::size_t scale = kNoSlot;
  double min = 0, max = 0;
  bool weight = false;
  double weight_scale = 0;                 // weights: the sum over the channel
  const ParameterInfo* divided = nullptr;  // f0: the weight of the lobes that f0 divides
  bool without_lobe = false;               // f0: that weight is 0
  bool moves_shapes = false;               // a shape moves with the parameter along its profile
  std::size_t times = kNoSlot;             // of a product: the number of its other factor
};

// Returns the product of two weights, numbers `a` and `b` of `all`.
Reported product_of(const std::vector<Reported>& all, std::size_t a, std::size_t b);

// Returns every shape parameter, the direction of the tangent, and every weight of every channel, at the
// solver's parameters p.
std::vector<Reported> reported_parameters(const Model& model, std::span<const double> p);

// Returns the values at distance `half_width` on either side of the value at p. For a shape parameter, the
// distance is on the solver's scale (log alpha). For other parameters, the values are clipped to the range.
Extent extent_of(const Reported& r, const Model& model, std::span<const double> p, double half_width);

// Returns whether a standard error is too large to be informative: a factor of e on a logarithmic scale,
// half of the range on other scales, a quarter of the range for f0, half of the channel's weights for a
// weight, an eighth of a half turn for the tangent. `error` is on the solver's scale for a shape parameter.
bool says_nothing(const Reported& r, const Model& model, double error);

// Return the interval of an estimate, without and with lack of fit. An open end is infinite.
Extent interval_of(const Estimate& e);
Extent interval_with_lack_of_fit(const Estimate& e);
// Returns "0.1 to 0.3", "at least 0.1" if one end is open, "any value" if both are, and "-" if the interval
// is unknown.
std::string extent_text(Extent e, int digits = 4);

// Returns "ks[r]", or "alpha" if all channels share the parameter.
std::string label(const Estimate& e);
std::string label(const std::string& name, const std::string& channel);
// Returns "sigma 0.3, alpha_x 0.1, alpha_y 0.1", the shape of the first channel.
std::string shape_text(const Material& m);
// Returns "a, b and c".
std::string listed(const std::vector<std::string>& names);
// Returns "ks (r, g)" for every name with the given status.
std::vector<std::string> names_with(const std::vector<Reported>& all, Status status, std::size_t channels);
// Returns advice on which measurements to add or which parameters to fix if some parameters are not
// identifiable.
std::string advice(const std::vector<Reported>& all, const Model& model);

}  // namespace brdf::fit
