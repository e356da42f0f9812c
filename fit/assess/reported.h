// The parameters as reports name them: functions of the solver's, with their gradients.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fit/assess/result.h"
#include "fit/model/model.h"

namespace brdf::fit {

// A reported parameter as a function of the solver's: value and gradient by the slots.
struct Reported {
  Estimate estimate;
  const ParameterInfo* info = nullptr;  // never null once reported
  std::vector<std::pair<std::size_t, double>> gradient;
  std::size_t slot = kNoSlot;   // a shape parameter's own
  std::size_t scale = kNoSlot;  // of any shape parameter: a slot on whose scale its interval is symmetric
  double min = 0, max = 0;
  bool weight = false;
  double weight_scale = 0;                 // weights: the channel's sum
  const ParameterInfo* divided = nullptr;  // f0: the weight whose lobes it divides
  bool without_lobe = false;               // f0: that weight is 0
  bool moves_shapes = false;               // a shape goes along with it on its profile
  std::size_t times = kNoSlot;             // of a product: the number of its other factor
};

// The product of two weights, numbers `a` and `b` of `all`.
Reported product_of(const std::vector<Reported>& all, std::size_t a, std::size_t b);

// Every shape parameter, the tangent's direction and every
// weight of every channel, at the solver's parameters p.
std::vector<Reported> reported_parameters(const Model& model, std::span<const double> p);

// The values so far to either side of the one at p: on the solver's scale for a shape parameter (log alpha),
// within its range for the others.
Extent extent_of(const Reported& r, const Model& model, std::span<const double> p, double half_width);

// Whether a standard error is no information: a factor of e on a logarithmic scale, half of the range on
// others, a quarter for f0, half of the channel's weights for a weight, an eighth of a half turn for the
// tangent. On the solver's scale for a shape parameter.
bool says_nothing(const Reported& r, const Model& model, double error);

// The interval of an estimate, and the one with lack of fit: infinite where an end is open.
Extent interval_of(const Estimate& e);
Extent interval_with_lack_of_fit(const Estimate& e);
// "0.1 to 0.3"; with an end that is open "at least 0.1"; "any value" with two; "-" where it is not known.
std::string extent_text(Extent e, int digits = 4);

// "ks[r]"; "alpha" where all channels share it.
std::string label(const Estimate& e);
std::string label(const std::string& name, const std::string& channel);
// "sigma 0.3, alpha_x 0.1, alpha_y 0.1": of the first channel.
std::string shape_text(const Material& m);
// "a, b and c".
std::string listed(const std::vector<std::string>& names);
// "ks (r, g)" for every name with the given status.
std::vector<std::string> names_with(const std::vector<Reported>& all, Status status, std::size_t channels);
// What to measure or fix where some parameters are not identified.
std::string advice(const std::vector<Reported>& all, const Model& model);

}  // namespace brdf::fit
