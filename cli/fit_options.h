// What `fit` and the verbs that fit on their way can be told about it: the same options, read the same way.
#pragma once

#include <string>
#include <vector>

#include "fit/fit.h"

namespace CLI {
class App;
}

namespace brdf::cli {

struct FitChoice {
  std::string form = "all", robust;
  std::vector<std::string> fix, start, bounds;
  bool physical = false;
  fit::FitOptions fit{.metric = fit::Metric::automatic};
};

// Adds --form, --metric and what else shapes a fit. The choice must outlive the parsing.
void add_fit_options(CLI::App& verb, FitChoice& choice);

// What the words mean; its `interrupted` is watch_for_interrupt()'s. Throws InputError.
fit::FitOptions fit_options(const FitChoice& choice);
// "all", "every", "ward" or "oren_nayar+ward"; none for "auto", which chooses by itself. Throws InputError.
std::vector<std::vector<Reflectance>> models_of(const std::string& form);
// The options as a shell takes them, those left out that are as they were: " --form ward --fix ks=0". With the version it
// is everything that decides a result.
std::string words_of(const FitChoice& choice);

// From now on Ctrl-C asks for the best so far; a second one ends the program. Where it is ignored it stays so.
void watch_for_interrupt();
bool was_interrupted();

}  // namespace brdf::cli
