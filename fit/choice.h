// What somebody asks of a fit in words: on the command line, or from another language.
#pragma once

#include <string>
#include <vector>

#include "fit/fit.h"

namespace brdf::fit {

struct FitChoice {
  std::string form = "all", robust;
  std::vector<std::string> fix, start, bounds;
  bool physical = false;
  std::string
      shape;  // over the channels: "shared", "free", "smooth", "smooth:DEGREE"; "": as the options say
  FitOptions options{.metric = Metric::automatic};
};

// What the words mean. Throws InputError.
FitOptions options_of(const FitChoice& choice);
// "all", "every", "ward" or "oren_nayar+ward"; none for "auto", which chooses by itself. Throws InputError.
std::vector<std::vector<Reflectance>> models_of(const std::string& form);
// The choice as a shell takes it, those left out that are as they were: " --form ward --fix ks=0". With the
// version it is everything that decides a result.
std::string words_of(const FitChoice& choice);
// The same word by word.
std::vector<std::string> arguments_of(const FitChoice& choice);

}  // namespace brdf::fit
