// What `fit` and the verbs that fit on their way can be told about it: the same options, read the same way.
#pragma once

#include "fit/choice.h"

namespace CLI {
class App;
}

namespace brdf::cli {

// Adds --form, --metric and what else shapes a fit. The choice must outlive the parsing.
void add_fit_options(CLI::App& verb, fit::FitChoice& choice);

// Adds --bootstrap.
void add_bootstrap_option(CLI::App& verb, fit::FitChoice& choice);
// Adds --no-pictures.
void add_pictures_option(CLI::App& verb, bool& no_pictures);

// What the choice means; its `interrupted` is watch_for_interrupt()'s. Where no more than one of `jobs` files is fitted at a
// time, its models are fitted side by side. Throws InputError.
fit::FitOptions fit_options(const fit::FitChoice& choice, unsigned jobs);

// From now on Ctrl-C asks for the best so far; a second one ends the program. Where it is ignored it stays so.
void watch_for_interrupt();
bool was_interrupted();

}  // namespace brdf::cli
