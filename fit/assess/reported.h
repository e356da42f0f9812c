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
  std::vector<std::pair<std::size_t, double>> gradient;
  std::size_t slot = kNoSlot;  // a shape parameter's own
  double min = 0, max = 0;
  double weight_scale = 0;  // weights: the channel's sum
  bool fresnel = false, weight = false;
};

// Every shape parameter, the tangent's direction and every
// weight of every channel, at the solver's parameters p.
std::vector<Reported> reported_parameters(const Model& model, std::span<const double> p);

// "ks[r]".
std::string label(const Estimate& e);
// "a, b and c".
std::string joined(const std::vector<std::string>& names);
// "ks (r, g)" for every name with the given status.
std::vector<std::string> names_with(const std::vector<Reported>& all, Status status, std::size_t channels);
// What to measure or fix where some parameters are not identified.
std::string advice(const std::vector<Reported>& all, const Model& model);

}  // namespace brdf::fit
