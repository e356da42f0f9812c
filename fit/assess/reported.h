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
};

// Every shape parameter, the tangent's direction and every
// weight of every channel, at the solver's parameters p.
std::vector<Reported> reported_parameters(const Model& model, std::span<const double> p);

// The values so far to either side of the one at p: on the solver's scale for a shape parameter (log alpha), within its
// range for the others.
Extent extent_of(const Reported& r, const Model& model, std::span<const double> p, double half_width);

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
