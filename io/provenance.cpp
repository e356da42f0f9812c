#include "io/provenance.h"

#include <string_view>

#include "io/shell.h"

namespace brdf::io {
namespace {

std::string& recorded_command() {
  static std::string command;
  return command;
}

}  // namespace

void record_command_line(int argc, const char* const* argv) {
  std::string command = "brdf";
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    if (word == "-o" || word == "--output" || word == "--report") {
      ++k;
      continue;
    }
    if (word.starts_with("-o") || word.starts_with("--output=") || word.starts_with("--report=")) continue;
    command += ' ' + shell_word(word);
  }
  recorded_command() = command;
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
