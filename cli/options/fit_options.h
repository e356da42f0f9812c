// What `fit` and the verbs that fit on their way can be told about it: the same options, read the same way.
#pragma once

#include "fit/choice.h"
#include "work/files.h"

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

// What the choice means (work/options.h), until the user interrupts it.
fit::FitOptions fit_options(const fit::FitChoice& choice, unsigned jobs);

// Adds --normals, of a stack.
void add_normals_option(CLI::App& verb, work::StackOptions& options);
// Adds all that a plan keeps.
void add_task_options(CLI::App& verb, work::TaskOptions& options);
// The same of a plan's words. Throws InputError.
work::TaskOptions task_options_of(const std::vector<std::string>& words);

// This program to the rooms that work for it: the user interrupts, and sentences go to stderr.
work::Caller this_program();

// From now on Ctrl-C asks for the best so far; a second one ends the program. Where it is ignored it stays
// so.
void watch_for_interrupt();
bool was_interrupted();

}  // namespace brdf::cli
