// brdf_check CERTIFICATE: the check of `brdf prove --check` as a separate program, which contains no
// search.
#include <cstring>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/material/settings.h"
#include "prove/check/judge.h"

namespace {

constexpr const char* kUsage =
    "usage: brdf_check [--help | --version] [--require PROPERTIES] [--property PROPERTIES] [--form FORM] "
    "CERTIFICATE\n";
constexpr const char* kHelp =
    "\n"
    "Verifies a certificate of `brdf prove -o`. The bounds of every box are computed again and must decide "
    "the claim, and\n"
    "the boxes must cover the whole domain. The verdict of each result follows from its numbers. This "
    "program contains no search.\n"
    "\n"
    "  --require PROPERTIES   these must be proved for every selected form and channel; separated by commas\n"
    "  --property PROPERTIES  as --require, and other properties are not judged\n"
    "  --form FORM            selects a form (may be repeated); default: all forms of the certificate\n"
    "\n"
    "Exit code: 0 if every result is confirmed and proved and all required results exist; 1 otherwise; 2 for "
    "bad input.\n"
    "Example: brdf prove --form phong -o certificate.json; brdf_check --require energy certificate.json\n";

struct Words {
  std::vector<std::string> required, properties, forms;
  std::string file;
};

void add_names(std::vector<std::string>& names, std::string_view text) {
  std::vector<std::string_view> fields;
  brdf::io::split(text, ',', fields);
  names.insert(names.end(), fields.begin(), fields.end());
}

// Returns std::nullopt if the words are not valid for this program.
std::optional<Words> read(int argc, char** argv) {
  Words words;
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    if (!word.starts_with("--")) {
      if (!std::exchange(words.file, word).empty()) return std::nullopt;
      continue;
    }
    const std::size_t equals = word.find('=');
    const std::string_view name = word.substr(0, equals);
    if (equals == word.npos && k + 1 == argc) return std::nullopt;
    const std::string_view value = equals == word.npos ? argv[++k] : word.substr(equals + 1);
    if (name == "--require")
      add_names(words.required, value);
    else if (name == "--property")
      add_names(words.properties, value);
    else if (name == "--form")
      words.forms.emplace_back(value);
    else
      return std::nullopt;
  }
  if (words.file.empty()) return std::nullopt;
  return words;
}

}  // namespace

int main(int argc, char** argv) {
  const auto alone = [&](const char* word) { return argc == 2 && std::strcmp(argv[1], word) == 0; };
  if (alone("--help") || alone("-h")) {
    std::cout << kUsage << kHelp;
    return 0;
  }
  if (alone("--version")) {
    std::cout << "brdf_check " BRDF_VERSION << '\n';
    return 0;
  }
  const std::optional<Words> words = read(argc, argv);
  if (!words) {
    std::cerr << kUsage;
    return 2;
  }
  try {
    brdf::prove::Asked asked;
    asked.required = brdf::prove::properties_named("--require", words->required);
    asked.properties = brdf::prove::properties_named("--property", words->properties);
    for (const std::string& form : words->forms)
      asked.forms.emplace_back(brdf::io::require_form(form).info().name);
    const brdf::prove::Judged judged = brdf::prove::judge(brdf::io::read_content(words->file), asked);
    brdf::prove::print(std::cout, judged);
    return judged.good ? 0 : 1;
  } catch (const brdf::InputError& error) {
    std::cerr << "brdf_check: " << brdf::io::printable(error.what()) << '\n';
    return 2;
  }
}
