// The verbs of the program, and functions to declare them.
#pragma once

#include <functional>

namespace CLI {
class App;
}

// Each verb is one file, cli/verbs/<name>.cpp, that defines add_<name>. This function declares the verb's
// options and its action. Invalid input is reported by InputError, and a failure of the environment by
// EnvironmentError (io/files/error.h). main() turns these exceptions into one line on stderr and exit code 2
// or 3.
namespace brdf::cli {

// Exit codes of the program. undecided: these inputs do not answer the question (`consensus`, `compare`).
enum class Exit { good = 0, failed = 1, bad_input = 2, environment = 3, undecided = 4 };

// The purpose of a verb; `brdf --help` groups the verbs by purpose.
enum class Purpose { begin, look, measure, judge, ship };
// Adds a verb without options.
CLI::App* add_verb(CLI::App& app, Purpose purpose, const char* name, const char* description);

// Sets the action of the verb. `run` is called after the command line has been parsed; its result is the
// program's exit code.
void on_run(CLI::App& verb, std::function<Exit()> run);

// The verbs in the order of the help: the verbs to begin with, then by purpose. CMake reads the order here.
// `describe` is hidden; the build uses it to generate man pages and completions.
void add_study(CLI::App& app);
void add_fit(CLI::App& app);
void add_validate(CLI::App& app);
void add_models(CLI::App& app);
void add_doctor(CLI::App& app);
void add_eval(CLI::App& app);
void add_render(CLI::App& app);
void add_lobes(CLI::App& app);
void add_view(CLI::App& app);
void add_maps(CLI::App& app);
void add_synth(CLI::App& app);
void add_convert(CLI::App& app);
void add_describe_table(CLI::App& app);
void add_next(CLI::App& app);
void add_compare(CLI::App& app);
void add_consensus(CLI::App& app);
void add_plan(CLI::App& app);
void add_work(CLI::App& app);
void add_collect(CLI::App& app);
void add_check_shader(CLI::App& app);
void add_prove(CLI::App& app);
void add_albedo(CLI::App& app);
void add_recommend(CLI::App& app);
void add_parity(CLI::App& app);
void add_trade(CLI::App& app);
void add_convert_parameters(CLI::App& app);
void add_export(CLI::App& app);
void add_describe(CLI::App& app);

// Adds a verb that this build lacks; it ends with exit code 3.
void add_missing(CLI::App& app, const char* verb);
// Adds all verbs. CMake generates this function from the existing files.
void add_verbs(CLI::App& app);

}  // namespace brdf::cli
