// Weights of either sign that keep f from falling below 0, and the albedo from rising above 1.
#pragma once

#include <optional>
#include <string>

#include "fit/solve/minima.h"

namespace brdf::fit {

// What was done to a minimum whose f was negative, or whose albedo was above 1.
struct CuttingPlanes {
  std::size_t cuts = 0;   // limits that were added
  double free_value = 0;  // the least f without limits, in 1/sr
  Vec3<double> wi, wo;    // where it was found
  std::string channel;
  bool limits_albedo = false;  // some limits are about the albedo
  // The reason why f is not shown to be at least 0; empty if f is.
  std::string open;
};

// Finds the least value of every term with weights of either sign, over all directions, and its largest
// albedo if the model limits the albedo. While a value is below 0 (an albedo above 1), adds the limit at that
// place to the model and solves again from there. `best` becomes the new minimum. Returns std::nullopt if no
// limit is needed.
std::optional<CuttingPlanes> keep_within_limits(const FitData& data, Model& model, const Residual& residual,
                                                const FitOptions& options, Minimum& best);

}  // namespace brdf::fit
