#include "work/job.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <tuple>
#include <utility>

#include "io/files/content.h"
#include "io/files/digest.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/output.h"
#include "io/files/provenance.h"
#include "io/files/text.h"

namespace brdf::work {
namespace {

namespace fs = std::filesystem;
using io::Json;
using io::JsonPlace;

constexpr const char* kPlanFile = "plan.json";
constexpr const char* kFormat = "brdf-plan";
constexpr const char* kUnitFormat = "brdf-unit 1";
constexpr std::size_t kUnitsPerFolder = 1000;             // network file systems are slow in large folders
constexpr std::size_t kMostUnits = std::size_t{1} << 20;  // the largest stack, with units of one tile
constexpr double kMostSide = 1e9, kMostBytes = 0x1p53;

fs::path unit_path(const fs::path& job, std::size_t unit) {
  char folder[24], name[32];
  std::snprintf(folder, sizeof folder, "%03zu", unit / kUnitsPerFolder);
  std::snprintf(name, sizeof name, "%05zu.unit", unit);
  return job / "units" / folder / name;
}

// Returns the number of units that units() makes.
std::size_t count_units(const Plan& plan) {
  return ((plan.width - 1) / plan.unit_width + 1) * ((plan.height - 1) / plan.unit_height + 1);
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
          {"units", count_units(plan)},
          {"inputs", inputs}};
}

std::string key_of(const Plan& plan) {
  return io::sha256(io::to_line(content_of(plan)));
}

// Returns two whole numbers.
std::pair<std::size_t, std::size_t> sides_in(const JsonPlace& place) {
  const auto side = [&](std::size_t k) { return std::size_t(place.at(k).whole(1, kMostSide)); };
  return {side(0), side(1)};
}

Plan plan_in(const JsonPlace& root) {
  Plan plan;
  plan.version = root.at("brdf_version").text();
  plan.command = root.at("command").text();
  plan.verb = root.at("verb").text();
  if (!root.at("stack").value().is_null()) plan.stack = root.at("stack").text();
  const JsonPlace options = root.at("options"), unit_size = root.at("unit_size"), inputs = root.at("inputs");
  for (std::size_t k = 0; k < options.size(); ++k) plan.options.push_back(options.at(k).text());
  plan.directory = root.at("directory").text();
  std::tie(plan.width, plan.height) = sides_in(root.at("extent"));
  std::tie(plan.unit_width, plan.unit_height) = sides_in(unit_size);
  if (count_units(plan) > kMostUnits)
    unit_size.fail("makes more than " + std::to_string(kMostUnits) + " units");
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const JsonPlace input = inputs.at(k);
    plan.inputs.push_back({input.at("file").text(), std::uint64_t(input.at("bytes").whole(0, kMostBytes)),
                           input.at("sha256").text()});
  }
  plan.key = root.at("key").text();
  return plan;
}

// Returns the key of the units that this program does. The key of a plan of another version differs, so that
// the results of two versions are never put together: the units of the other version are done again.
std::string unit_key(const Plan& plan) {
  const std::string mine = io::provenance().version;
  return plan.version == mine ? plan.key : io::sha256(plan.key + " " + mine);
}

// A unit's file begins with a line that identifies the unit and holds the hash of all that follows. The
// unit's files follow: for each, a line with the lengths of name and content, and then name and content.
std::string head_of(const Plan& plan, std::size_t unit, std::string_view rest) {
  return std::string(kUnitFormat) + " " + unit_key(plan) + " " + std::to_string(unit) + " " +
         io::sha256(rest) + "\n";
}

std::string packed(const std::vector<UnitFile>& files) {
  std::string out;
  for (const UnitFile& file : files)
    out += std::to_string(file.name.size()) + " " + std::to_string(file.bytes.size()) + "\n" + file.name +
           file.bytes;
  return out;
}

// Returns true if the name stays within the folder for results.
bool stays_inside(const fs::path& name) {
  if (name.empty() || name.is_absolute() || name.native().find('\0') != name.native().npos) return false;
  return std::ranges::none_of(name, [](const fs::path& part) { return part == ".."; });
}

// Returns std::nullopt if lengths and bytes do not match. The checks are needed since a hash proves that
// nothing was changed, but not the origin of the file.
std::optional<std::vector<UnitFile>> unpacked(std::string_view rest) {
  std::vector<UnitFile> files;
  while (!rest.empty()) {
    std::size_t sizes[2] = {};
    for (const std::size_t k : {0, 1}) {
      const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), sizes[k]);
      const std::size_t read = std::size_t(stop - rest.data());
      if (error != std::errc() || read == rest.size() || *stop != " \n"[k]) return std::nullopt;
      rest.remove_prefix(read + 1);
    }
    if (sizes[0] > rest.size() || sizes[1] > rest.size() - sizes[0]) return std::nullopt;
    files.push_back({std::string(rest.substr(0, sizes[0])), std::string(rest.substr(sizes[0], sizes[1]))});
    if (!stays_inside(files.back().name)) return std::nullopt;
    rest.remove_prefix(sizes[0] + sizes[1]);
  }
  return files;
}

// Returns the bytes of a unit's file, or std::nullopt if the file does not exist.
std::optional<std::string> unit_bytes(const fs::path& job, std::size_t unit) {
  const fs::path file = unit_path(job, unit);
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  return io::read_result(file).bytes;
}

// Returns the content of a unit's file, or std::nullopt if the file is not valid for this unit.
std::optional<std::vector<UnitFile>> files_in(std::string_view bytes, const Plan& plan, std::size_t unit) {
  const std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view rest = bytes.substr(end + 1);
  if (bytes.substr(0, end + 1) != head_of(plan, unit, rest)) return std::nullopt;
  return unpacked(rest);
}

}  // namespace

std::vector<texel::Region> Plan::units() const {
  return texel::divided({0, 0, width, height}, unit_width, unit_height);
}

Plan completed(Plan plan, const std::vector<std::string>& inputs) {
  if (count_units(plan) > kMostUnits)
    throw InputError("--unit-size: makes " + std::to_string(count_units(plan)) + " units, more than " +
                     std::to_string(kMostUnits));
  for (const std::string& file : inputs) {
    if (!fs::is_regular_file(file)) throw InputError(file + ": no such file");
    plan.inputs.push_back({file, fs::file_size(file), io::sha256_of_file(file)});
  }
  plan.version = io::provenance().version;
  plan.key = key_of(plan);
  return plan;
}

void write_plan(const fs::path& job, const Plan& plan) {
  if (fs::exists(job / kPlanFile)) {
    if (read_plan(job).key == plan.key) return;
    throw InputError(
        job.string() +
        ": contains a plan with different inputs, options, units or version: use another folder");
  }
  io::make_folder(job);
  Json j = content_of(plan);
  j["key"] = plan.key;
  io::write_file_atomically(job / kPlanFile, io::to_text(j));
}

Plan read_plan(const fs::path& job) {
  const fs::path file = job / kPlanFile;
  if (!fs::exists(file)) throw InputError(job.string() + ": is not a job: the folder has no " + kPlanFile);
  const Json json = io::read_json(file);
  Plan plan = plan_in({json, file.string()});
  if (plan.key != key_of(plan)) throw InputError(file.string() + ": the plan was changed after it was made");
  return plan;
}

void check_input(const Input& input, bool content) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(input.file, error);
  if (error) throw InputError(input.file + ": cannot be read: " + error.message());
  if (bytes != input.bytes || (content && io::sha256_of_file(input.file) != input.sha256))
    throw InputError(input.file + ": has changed since the work was planned");
}

UnitState state_of(const fs::path& job, const Plan& plan, std::size_t unit) {
  const std::optional<std::string> bytes = unit_bytes(job, unit);
  if (!bytes) return UnitState::missing;
  return files_in(*bytes, plan, unit) ? UnitState::done : UnitState::damaged;
}

std::optional<std::vector<UnitFile>> read_unit(const fs::path& job, const Plan& plan, std::size_t unit) {
  const std::optional<std::string> bytes = unit_bytes(job, unit);
  return bytes ? files_in(*bytes, plan, unit) : std::nullopt;
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

}  // namespace brdf::work
