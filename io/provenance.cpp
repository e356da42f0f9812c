#include "io/provenance.h"

#include <string_view>

namespace brdf::io {
namespace {

std::string& recorded_command() {
  static std::string command;
  return command;
}

std::string quoted(std::string_view word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) return std::string(word);
  std::string result = "'";
  for (const char c : word) {
    if (c == '\'')
      result += "'\\''";
    else if (c == '\n')
      result += ' ';  // a header line must stay one line
    else
      result += c;
  }
  return result + "'";
}

}  // namespace

void record_command_line(int argc, const char* const* argv) {
  std::string command = "brdf";
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    if (word == "-o" || word == "--output") {
      ++k;
      continue;
    }
    if (word.starts_with("--output=")) continue;
    command += ' ' + quoted(word);
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
