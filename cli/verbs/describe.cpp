#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/surface/surface.h"
#include "cli/verb.h"
#include "io/files/output.h"

namespace brdf::cli {

// This verb is not listed by `brdf --help`; the build calls it.
void add_describe(CLI::App& app) {
  struct DescribeCall {
    std::string as, folder;
  };
  auto options = std::make_shared<DescribeCall>();
  CLI::App* verb = app.add_subcommand("describe", "Describe the command line for other programs");
  verb->group("");
  verb->add_option("AS", options->as, "json, completion for bash, zsh or fish, or man pages")
      ->required()
      ->check(CLI::IsMember({"json", "bash", "zsh", "fish", "man"}));
  verb->add_option("-o,--output", options->folder, "Folder of the man pages")->default_str(".");
  verb->footer("Example: brdf describe bash");
  on_run(*verb, [options, &app] {
    if (options->as == "man") {
      const std::filesystem::path folder = options->folder.empty() ? "." : options->folder;
      io::make_folder(folder);
      for (const Page& page : man_pages(app)) io::write_file_atomically(folder / page.name, page.text);
    } else {
      std::cout << (options->as == "json"   ? surface_json(app)
                    : options->as == "bash" ? bash_completion(app)
                    : options->as == "fish" ? fish_completion(app)
                                            : zsh_completion(app));
    }
    return Exit::good;
  });
}

}  // namespace brdf::cli
