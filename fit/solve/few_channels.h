// A spectrum's shape, told by a few of its bands.
#pragma once

#include <optional>

#include "fit/model/data.h"
#include "fit/model/model.h"

namespace brdf::fit {

struct FewChannels {
  FitData data;
  Model model;  // of the same slots of shapes as the model of all channels
};

// Where many channels share one shape: some of them, evenly spread, from the first to the last. Minima are
// looked for on these; the work grows with the cube of the number of unknowns, and each channel has its own
// weights. None where the channels are few, have shapes of their own, or options with a value for each.
std::optional<FewChannels> few_channels(const FitData& data, const Model& model, const FitOptions& options);

}  // namespace brdf::fit
