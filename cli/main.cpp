#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>
#include <new>
#include <string>

#include "cli/verbs.h"
#include "io/error.h"
#include "io/provenance.h"
#include "io/text.h"

namespace brdf::cli {
namespace {

Exit exit_code = Exit::good;

int report(const std::string& message, Exit code) {
  std::cout.flush();
  std::cerr << "brdf: " << io::printable(message) << '\n';
  return static_cast<int>(code);
}

// The verb that the command line was for, for the hint after a usage error.
std::string verb_name(const CLI::App& app) {
  for (const CLI::App* verb : app.get_subcommands()) return " " + verb->get_name();
  return "";
}

int run(int argc, char** argv) {
  CLI::App app(
      "Models of surface reflection: fitted to measurements, judged, rendered.\n"
      "Exit codes: 0 good, 1 a result that fails, 2 bad input or usage, 3 the environment lacks something.",
      "brdf");
  app.set_version_flag("--version", "brdf " BRDF_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  add_verbs(app);
  io::record_command_line(argc, argv);
  try {
    app.parse(argc, argv);
    return static_cast<int>(exit_code);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    if (app.get_subcommands().empty() && argc > 1 && argv[1][0] != '-')
      return report("'" + std::string(argv[1]) + "' is no verb (see brdf --help)", Exit::bad_input);
    return report(std::string(error.what()) + " (see brdf" + verb_name(app) + " --help)", Exit::bad_input);
  } catch (const InputError& error) {
    return report(error.what(), Exit::bad_input);
  } catch (const EnvironmentError& error) {
    return report(error.what(), Exit::environment);
  } catch (const std::bad_alloc&) {
    return report("not enough memory", Exit::environment);
  } catch (const std::exception& error) {
    return report(std::string("stopped: ") + error.what(), Exit::environment);
  }
}

}  // namespace

void on_run(CLI::App& verb, std::function<Exit()> run) {
  verb.callback([run = std::move(run)] { exit_code = run(); });
}

void add_missing(CLI::App& app, const char* name) {
  CLI::App* verb = app.add_subcommand(name, "(left out of this build)");
  verb->allow_extras();
  on_run(*verb, [name]() -> Exit {
    throw EnvironmentError(std::string("this build has no `") + name +
                           "`: a library it needs was missing (see the messages of cmake)");
  });
}

}  // namespace brdf::cli

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_DFL);  // `brdf models | head` ends quietly
  return brdf::cli::run(argc, argv);
}
