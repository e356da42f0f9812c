#include "cli/options/streams.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>

#include "cli/surface/option_table.h"
#include "io/files/error.h"
#include "io/files/inputs.h"
#include "io/files/standard_input.h"

namespace brdf::cli {
namespace {

constexpr std::string_view kStandardOutput = "/dev/stdout";

// Options that read one table, one material or one other file of text, which names no further files.
constexpr std::array<std::string_view, 14> kInputs{
    "SAMPLES",    "DIRECTIONS", "MATERIAL",  "MATERIALS",   "FILES",    "IN",      "--material",
    "--measured", "--grid",     "--compare", "--reference", "--ledger", "--check", "--reach"};
constexpr std::array<std::string_view, 3> kOutputs{"OUT", "--output", "--report"};

// Verbs with folders or pictures as results, and verbs with inputs that other processes read later.
constexpr std::array<std::string_view, 7> kWithoutStreamedOutput{"study", "render",    "lobes",   "maps",
                                                                 "plan",  "recommend", "describe"};
constexpr std::array<std::string_view, 3> kWithoutStreamedInput{"plan", "work", "collect"};

template <std::size_t N>
bool holds(const std::array<std::string_view, N>& list, std::string_view name) {
  return std::ranges::find(list, name) != list.end();
}

bool writes(std::string_view name) {
  return holds(kOutputs, name) || name == "--save-as" || name == "--screenshot" || name == "--loss-map" ||
         name == "--junit" || name == "--sarif";
}

// Replaces `-` by the name of the stream. Returns the fault, or an empty string. `taken`: the option that
// reads standard input; empty at first.
std::string to_stream(const std::string& verb, const std::string& name, std::string& taken,
                      std::string& text) {
  if (text != "-") return {};
  if (writes(name)) {
    if (!holds(kOutputs, name) || holds(kWithoutStreamedOutput, verb))
      return "'-' cannot be used: a folder or a picture cannot go to standard output; give a name";
    text = kStandardOutput;
    return {};
  }
  if (!holds(kInputs, name) || holds(kWithoutStreamedInput, verb))
    return "'-' cannot be used: this file cannot come from standard input; give its name";
  if (!taken.empty())
    return "'-' is given twice: standard input can be read once, and " + taken + " reads it";
  taken = name;
  text = io::kStandardInput;
  return {};
}

void use_streams_in(CLI::App& app, const std::shared_ptr<std::string>& taken) {
  const std::string verb = app.get_name();
  for (CLI::Option* option : app.get_options()) {
    const std::string name = table_name(*option);
    if (!is_file(value_of(verb, *option)) && name != "--grid") continue;
    option->transform(CLI::Validator(
        [verb, name, taken](std::string& text) { return to_stream(verb, name, *taken, text); }, ""));
  }
}

}  // namespace

void use_streams(CLI::App& app) {
  const auto taken = std::make_shared<std::string>();
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    use_streams_in(*verb, taken);
}

void keep_inputs(const CLI::App& verb) {
  std::vector<io::Target> outputs;
  std::vector<std::filesystem::path> inputs;
  for (const CLI::Option* option : verb.get_options()) {
    const std::string name = table_name(*option);
    if (name == "--state" || !is_file(value_of(verb.get_name(), *option))) continue;
    for (const std::string& file : option->results()) {
      std::error_code unreadable;
      if (!std::filesystem::is_regular_file(file, unreadable)) continue;  // nothing could be lost
      if (writes(name))
        outputs.push_back({name == "--output" ? "-o" : name, file});
      else
        inputs.emplace_back(file);
    }
  }
  for (const io::Target& output : outputs) io::check_targets({output}, inputs);
  if (verb.get_name() != "view") io::keep_inputs();  // a window saves over the files that it shows
}

bool is_stream(const std::string& file) {
  return io::is_standard_input(file) || file == kStandardOutput;
}

void require_file(const io::Target& output, const std::string& content) {
  if (is_stream(output.path))
    throw InputError(output.option + " -: " + content + ", which cannot go to standard output: name a file");
}

TextStream text_stream(const std::vector<io::Target>& outputs, bool json) {
  std::string taken = json ? "--json" : "";
  for (const io::Target& output : outputs) {
    if (!is_stream(output.path)) continue;
    if (!taken.empty())
      throw InputError(output.option + " -: " + taken + " writes to standard output too: name a file");
    taken = output.option;
  }
  return taken.empty() || json ? TextStream::out : TextStream::error;
}

}  // namespace brdf::cli
