// Options of `fit` and of the verbs that run a fit as part of their work: the same options, parsed the same
// way.
#pragma once

#include "fit/choice.h"
#include "fit/samples.h"
#include "io/files/output.h"
#include "work/files.h"

namespace CLI {
class App;
}

namespace brdf::cli {

// Adds --form, --metric and the other options of a fit. `choice` must outlive the parsing.
void add_fit_options(CLI::App& verb, fit::FitChoice& choice);

// Adds --budget of a single table.
void add_budget_option(CLI::App& verb, fit::FitChoice& choice);
// Adds --bootstrap.
void add_bootstrap_option(CLI::App& verb, fit::FitChoice& choice);
// Adds --tolerance; fit::tolerance_of() parses its text.
void add_tolerance_option(CLI::App& verb, std::string& tolerance);
// Adds --no-pictures.
void add_pictures_option(CLI::App& verb, bool& no_pictures);

// Returns the options that the choice describes (work/options.h). The fit ends when the user interrupts it.
fit::FitOptions fit_options(const fit::FitChoice& choice, unsigned jobs);

// Throws InputError if one of the outputs is the budget that the table of the samples names.
void keep_budget(const std::vector<io::Target>& outputs, const fit::Samples& samples);

// Adds --normals, an option of stacks.
void add_normals_option(CLI::App& verb, work::StackOptions& options);
// Adds all options that a plan stores.
void add_task_options(CLI::App& verb, work::TaskOptions& options);
// Parses the options that a plan stores as words. Throws InputError.
work::TaskOptions task_options_of(const std::vector<std::string>& words);

// Connects this program to the libraries that work for it: forwards the user's interruption, and prints
// sentences on stderr.
work::Caller this_program();

// Makes the first Ctrl-C request the best result so far; a second one ends the program. If the signal is
// ignored when the function is called, it stays ignored.
void watch_for_interrupt();
// Returns true if the user has pressed Ctrl-C since watch_for_interrupt().
bool was_interrupted();

}  // namespace brdf::cli
