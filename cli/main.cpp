#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>

#include "cli/help.h"
#include "cli/options/next_step.h"
#include "cli/options/old_spelling.h"
#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/options/shader_options.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/surface/option_table.h"
#include "cli/verb.h"
#ifdef BRDF_HAS_FIT
#include "fit/solve/quiet.h"
#endif
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/file_buffer.h"
#include "io/files/leftovers.h"
#include "io/files/provenance.h"
#include "io/files/text.h"

namespace brdf::cli {
namespace {

Exit exit_code = Exit::good;

int report(std::string_view message, Exit code, std::string_view before = "") {
  std::cout.flush();
  erase_progress();
  const bool colours = colours_on(STDERR_FILENO);
  std::cerr << (colours ? "\x1b[31mbrdf:\x1b[0m " : "brdf: ") << before;
  try {
    const std::string text = io::printable(message);
    std::cerr << (isatty(STDERR_FILENO) ? folded(text, columns_of(STDERR_FILENO)) : text);
  } catch (const std::bad_alloc&) {  // memory may be exhausted
    std::cerr << "not enough memory";
  }
  std::cerr << '\n';
  return static_cast<int>(code);
}

// Opens substitutes for closed standard streams. Otherwise files would get the descriptors of these streams,
// and output would be written into them. The substitute for stdout cannot be written, which makes the loss
// of output visible.
void fill_standard_descriptors() {
  for (const int k : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(k, F_GETFD) < 0 && errno == EBADF)
      ::open(k == STDOUT_FILENO ? "/dev/full" : "/dev/null", k == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

// Redirects std::cout during its lifetime. finish() checks that all output was written.
class StandardOutput {
 public:
  StandardOutput() : buffer_(STDOUT_FILENO, isatty(STDOUT_FILENO) != 0), before_(std::cout.rdbuf(&buffer_)) {}
  StandardOutput(const StandardOutput&) = delete;
  StandardOutput& operator=(const StandardOutput&) = delete;
  ~StandardOutput() { std::cout.rdbuf(before_); }

  // Returns the exit code of the program. If output was lost, the exit code reports a failure.
  int finish(int code) {
    std::cout.flush();
    const bool has_failed =
        code == static_cast<int>(Exit::bad_input) || code == static_cast<int>(Exit::environment);
    if (buffer_.error() == 0 || has_failed) return code;
    std::cerr << "brdf: standard output: writing broke off: " << std::strerror(buffer_.error()) << '\n';
    return static_cast<int>(Exit::environment);
  }

 private:
  io::FileBuffer buffer_;
  std::streambuf* before_;
};

int run(int argc, char** argv) try {
  CLI::App app(
      "Models of surface reflection: fitted to measurements, judged, rendered.\n"
      "Exit codes: 0 good, 1 a result that fails, 2 bad input or usage, 3 the environment lacks something, "
      "4 undecided.",
      "brdf");
  app.set_version_flag("--version", "brdf " BRDF_VERSION);
  app.footer("Documentation: man brdf-VERB, and the folder docs of the source code.");
  app.require_subcommand(1);
  const int columns = columns_of(STDOUT_FILENO);
  // Must precede the verbs, which inherit the formatter.
  app.formatter(help_layout(columns ? columns : 80));
  add_verbs(app);
  require_plain_numbers(app);
  use_streams(app);
  add_quiet_option(app);
  group_options(app);
  io::record_command_line(argc, argv);
  if (argc == 1) {
    std::cout << app.help();
    return static_cast<int>(Exit::good);
  }
  std::vector<std::string> words = in_new_spelling({argv + 1, argv + argc});
  const std::string first = words.front();
  try {
    std::ranges::reverse(words);  // CLI11 expects the words in reverse order
    app.parse(std::move(words));
    return static_cast<int>(exit_code);
  } catch (const CLI::ParseError& error) {
    const bool is_understood = first.starts_with("-") || !app.get_subcommands().empty();
    if (error.get_exit_code() == 0 && is_understood) return app.exit(error);
    return report(usage_fault(app, error.what(), first), Exit::bad_input);
  }
} catch (const InputError& error) {
  return report(error.what(), Exit::bad_input);
} catch (const EnvironmentError& error) {
  return report(error.what(), Exit::environment);
} catch (const std::bad_alloc&) {
  return report("not enough memory", Exit::environment);
} catch (const std::filesystem::filesystem_error& error) {
  return report(io::cannot_be_used(error),
                io::is_of_the_name(error.code().value()) ? Exit::bad_input : Exit::environment);
} catch (const std::exception& error) {
  return report(error.what(), Exit::environment, "stopped: ");
}

}  // namespace

void on_run(CLI::App& verb, std::function<Exit()> run) {
  verb.callback([&verb, run = std::move(run)] {
    refuse_empty_values(verb);
    keep_inputs(verb);
    exit_code = run();
  });
}

CLI::App* add_verb(CLI::App& app, Purpose purpose, const char* name, const char* description) {
  constexpr std::array kHeadings{"Begin here", "Look", "Measure", "Judge", "Ship"};
  return app.add_subcommand(name, description)->group(kHeadings[static_cast<std::size_t>(purpose)]);
}

void add_missing(CLI::App& app, const char* name) {
  CLI::App* verb = app.add_subcommand(name, "(left out of this build)");
  verb->allow_extras();
  set_missing(name);
  on_run(*verb, [name]() -> Exit {
    throw EnvironmentError(std::string("this build has no `") + name +
                           "`: a library it needs was missing (see the messages of cmake)");
  });
}

}  // namespace brdf::cli

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_DFL);  // `brdf models | head` ends quietly
  brdf::cli::fill_standard_descriptors();
  brdf::io::remove_temporaries_on_signals();
  brdf::cli::use_shaders_in_materials();
#ifdef BRDF_HAS_FIT
  brdf::fit::silence_solver_log();
#endif
  brdf::cli::StandardOutput out;
  return out.finish(brdf::cli::run(argc, argv));
}
