// Determines the shape of a spectrum from a few of its bands.
#pragma once

#include <optional>

#include "fit/model/data.h"
#include "fit/model/model.h"

namespace brdf::fit {

struct FewChannels {
  FitData data;
  Model model;  // has the same shape slots as the model of all channels
};

// Returns a subset of the channels, evenly spread from the first to the last, if many channels share one
// shape. Minima are searched on this subset, because the work grows with the cube of the number of unknowns
// and each channel has its own weights. Returns std::nullopt if there are few channels, if they have shapes
// of their own, or if an option has a value for each channel.
std::optional<FewChannels> few_channels(const FitData& data, const Model& model, const FitOptions& options);

}  // namespace brdf::fit
