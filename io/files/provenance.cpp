#include "io/files/provenance.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/files/shell.h"

namespace brdf::io {
namespace {

// Options for the output's place and for the number of jobs. No value depends on them.
constexpr std::array<std::string_view, 6> kOfNoConsequence{"-o",     "--output",  "--report",
                                                           "--jobs", "--threads", "--unit-size"};

std::string& recorded_command() {
  static std::string command;
  return command;
}

}  // namespace

void record_command_line(int argc, const char* const* argv) {
  std::string command = "brdf";
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    const std::string_view option = word.substr(0, word.find('='));
    if (std::ranges::find(kOfNoConsequence, option) != kOfNoConsequence.end()) {
      if (option == word) ++k;
      continue;
    }
    if (word.starts_with("-o")) continue;
    command += ' ' + shell_word(word);
  }
  record_command(std::move(command));
}

void record_command(std::string command) {
  recorded_command() = std::move(command);
}

Provenance provenance(std::optional<std::uint64_t> seed) {
  return {BRDF_VERSION, recorded_command(), seed};
}

std::vector<std::pair<std::string, std::string>> provenance_fields(const Provenance& made) {
  std::vector<std::pair<std::string, std::string>> fields = {{"brdf_version", made.version}};
  if (!made.command.empty()) fields.emplace_back("command", made.command);
  if (made.seed) fields.emplace_back("seed", std::to_string(*made.seed));
  return fields;
}

}  // namespace brdf::io
