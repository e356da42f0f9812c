#include "maps/job.h"

#include <charconv>
#include <cstdio>
#include <tuple>
#include <utility>

#include "io/content.h"
#include "io/error.h"
#include "io/json.h"
#include "io/output.h"
#include "io/provenance.h"
#include "io/text.h"
#include "maps/digest.h"
#include "maps/stack_fit.h"

namespace brdf::maps {
namespace {

namespace fs = std::filesystem;
using io::Json;

constexpr const char* kPlanFile = "plan.json";
constexpr const char* kFormat = "brdf-plan";
constexpr const char* kUnitFormat = "brdf-unit 1";
constexpr std::size_t kUnitsPerFolder = 1000;  // network file systems are slow in large ones

fs::path unit_path(const fs::path& job, std::size_t unit) {
  char folder[24], name[32];
  std::snprintf(folder, sizeof folder, "%03zu", unit / kUnitsPerFolder);
  std::snprintf(name, sizeof name, "%05zu.unit", unit);
  return job / "units" / folder / name;
}

Json content_of(const Plan& plan) {
  Json inputs = Json::array();
  for (const Input& input : plan.inputs)
    inputs.push_back({{"file", input.file}, {"bytes", input.bytes}, {"sha256", input.sha256}});
  return {{"format", kFormat},
          {"version", 1},
          {"brdf_version", plan.version},
          {"command", plan.command},
          {"verb", plan.verb},
          {"stack", plan.stack.empty() ? Json() : Json(plan.stack)},
          {"options", plan.options},
          {"directory", plan.directory},
          {"extent", {plan.width, plan.height}},
          {"unit_size", {plan.unit_width, plan.unit_height}},
          {"units", plan.units().size()},
          {"inputs", inputs}};
}

std::string key_of(const Plan& plan) {
  return sha256(io::to_line(content_of(plan)));
}

Plan plan_of(const Json& j) {
  Plan plan;
  plan.version = j.at("brdf_version").get<std::string>();
  plan.command = j.at("command").get<std::string>();
  plan.verb = j.at("verb").get<std::string>();
  if (!j.at("stack").is_null()) plan.stack = j.at("stack").get<std::string>();
  plan.options = j.at("options").get<std::vector<std::string>>();
  plan.directory = j.at("directory").get<std::string>();
  std::tie(plan.width, plan.height) = j.at("extent").get<std::pair<std::size_t, std::size_t>>();
  std::tie(plan.unit_width, plan.unit_height) = j.at("unit_size").get<std::pair<std::size_t, std::size_t>>();
  for (const Json& input : j.at("inputs"))
    plan.inputs.push_back({input.at("file").get<std::string>(), input.at("bytes").get<std::uint64_t>(),
                           input.at("sha256").get<std::string>()});
  plan.key = j.at("key").get<std::string>();
  return plan;
}

// A unit's file: a line that says whose it is and what all that follows must be, then each file that it holds: a line
// with the lengths of name and content, and these.
std::string head_of(const Plan& plan, std::size_t unit, std::string_view rest) {
  return std::string(kUnitFormat) + " " + plan.key + " " + std::to_string(unit) + " " + sha256(rest) + "\n";
}

std::string packed(const std::vector<UnitFile>& files) {
  std::string out;
  for (const UnitFile& file : files)
    out += std::to_string(file.name.size()) + " " + std::to_string(file.bytes.size()) + "\n" + file.name +
           file.bytes;
  return out;
}

// Precondition: made by packed().
std::vector<UnitFile> unpacked(std::string_view rest) {
  std::vector<UnitFile> files;
  while (!rest.empty()) {
    std::size_t sizes[2] = {};
    for (std::size_t& size : sizes) {
      const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), size);
      rest.remove_prefix(std::size_t(stop - rest.data()) + 1);
    }
    files.push_back({std::string(rest.substr(0, sizes[0])), std::string(rest.substr(sizes[0], sizes[1]))});
    rest.remove_prefix(sizes[0] + sizes[1]);
  }
  return files;
}

// The bytes of a unit's file, where it is there.
std::optional<std::string> unit_bytes(const fs::path& job, std::size_t unit) {
  const fs::path file = unit_path(job, unit);
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  return io::read_content(file).bytes;
}

// What follows the first line, where that is right.
std::optional<std::string_view> valid_rest(std::string_view bytes, const Plan& plan, std::size_t unit) {
  const std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view rest = bytes.substr(end + 1);
  if (bytes.substr(0, end + 1) != head_of(plan, unit, rest)) return std::nullopt;
  return rest;
}

}  // namespace

std::vector<texel::Region> Plan::units() const {
  return units_of({0, 0, width, height}, unit_width, unit_height);
}

Plan completed(Plan plan, const std::vector<std::string>& inputs) {
  for (const std::string& file : inputs) {
    if (!fs::is_regular_file(file)) throw InputError(file + ": no such file");
    plan.inputs.push_back({file, fs::file_size(file), sha256_of_file(file)});
  }
  plan.version = io::provenance().version;
  plan.key = key_of(plan);
  return plan;
}

void write_plan(const fs::path& job, const Plan& plan) {
  if (fs::exists(job / kPlanFile)) {
    if (read_plan(job).key == plan.key) return;
    throw InputError(job.string() +
                     ": holds another plan, of other inputs, options or units: take another folder");
  }
  io::make_folder(job);
  Json j = content_of(plan);
  j["key"] = plan.key;
  io::write_file_atomically(job / kPlanFile, io::to_text(j));
}

Plan read_plan(const fs::path& job) {
  const fs::path file = job / kPlanFile;
  if (!fs::exists(file)) throw InputError(job.string() + ": no job: no " + kPlanFile + " in it");
  Plan plan;
  try {
    plan = plan_of(io::read_json(file));
  } catch (const Json::exception& error) {
    throw InputError(file.string() + ": no plan: " + error.what());
  }
  if (plan.unit_width == 0 || plan.unit_height == 0 || plan.key != key_of(plan))
    throw InputError(file.string() + ": was changed since the work was planned");
  if (const std::string mine = io::provenance().version; plan.version != mine)
    throw InputError(file.string() + ": planned by version " + plan.version + ", this is " + mine);
  return plan;
}

void check_input(const Input& input, bool content) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(input.file, error);
  if (error) throw InputError(input.file + ": cannot be read: " + error.message());
  if (bytes != input.bytes || (content && sha256_of_file(input.file) != input.sha256))
    throw InputError(input.file + ": is not what it was when the work was planned");
}

UnitState state_of(const fs::path& job, const Plan& plan, std::size_t unit) {
  const std::optional<std::string> bytes = unit_bytes(job, unit);
  if (!bytes) return UnitState::missing;
  return valid_rest(*bytes, plan, unit) ? UnitState::done : UnitState::damaged;
}

std::optional<std::vector<UnitFile>> read_unit(const fs::path& job, const Plan& plan, std::size_t unit) {
  const std::optional<std::string> bytes = unit_bytes(job, unit);
  if (!bytes) return std::nullopt;
  const std::optional<std::string_view> rest = valid_rest(*bytes, plan, unit);
  if (!rest) return std::nullopt;
  return unpacked(*rest);
}

void write_unit(const fs::path& job, const Plan& plan, std::size_t unit, const std::vector<UnitFile>& files) {
  const std::string rest = packed(files);
  const fs::path path = unit_path(job, unit);
  io::make_folder(path.parent_path());
  io::write_file_atomically(path, head_of(plan, unit, rest) + rest);
}

std::string array_text(const std::vector<std::size_t>& units) {
  std::string out;
  for (std::size_t k = 0; k < units.size();) {
    std::size_t last = k;
    while (last + 1 < units.size() && units[last + 1] == units[last] + 1) ++last;
    out += (out.empty() ? "" : ",") + std::to_string(units[k]);
    if (last > k) out += "-" + std::to_string(units[last]);
    k = last + 1;
  }
  return out;
}

}  // namespace brdf::maps
