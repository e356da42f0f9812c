// The choices of a fit as text, as given on the command line or by a caller in another language.
#pragma once

#include <string>
#include <vector>

#include "fit/fit.h"

namespace brdf::fit {

struct FitChoice {
  std::string form = "all", robust, budget;  // budget: the name of a file
  std::vector<std::string> fix, start, bounds;
  bool physical = false;
  // Variation over the channels: "shared", "free", "smooth" or "smooth:DEGREE". "" leaves the setting of
  // `options`.
  std::string shape;
  FitOptions options{.metric = Metric::automatic};
};

// Returns the options that the texts describe. Throws InputError.
FitOptions options_of(const FitChoice& choice);
// Returns the models for "all", "every", "ward", "oren_nayar+ward", or a list of these that commas separate.
// Returns an empty list for "auto", for which fit() builds the model itself. Throws InputError for an unknown
// form, for a model that is named twice, and for auto in a list.
std::vector<std::vector<Reflectance>> models_of(const std::string& form);
// Returns the choice in the syntax of a shell, without the options that have their default values: " --form
// ward --fix ks=0". Together with the version, this text contains everything that determines a result.
std::string words_of(const FitChoice& choice);
// Returns the same choice as one string per argument.
std::vector<std::string> arguments_of(const FitChoice& choice);

}  // namespace brdf::fit
