// Planned work. Plans and units have valid keys and hashes, so that the fuzzer reaches the checks behind
// them.
#include "io/files/digest.h"
#include "io/files/json.h"
#include "tests/fuzz/fuzz.h"
#include "work/job.h"

namespace brdf::fuzz {
namespace {

namespace fs = std::filesystem;

const Registered plans("plan", [](std::string_view input) {
  io::Json given = io::parse_json(std::string(input), "plan");
  if (given.is_object()) {
    given.erase("key");
    given["brdf_version"] = io::provenance().version;
    given["key"] = io::sha256(io::to_line(given));
  }
  const work::Plan plan = work::read_plan(folder_with("job", "plan.json", io::to_text(given)));
  const std::vector<texel::Region> units = plan.units();
  require(io::Json(units.size()) == given["units"], "a plan has the units that it says");
  std::size_t parts = 0;
  for (const texel::Region& unit : units) {
    require(unit.size() > 0 && unit.x + unit.width <= plan.width && unit.y + unit.height <= plan.height,
            "units lie in what is divided");
    parts += unit.size();
  }
  require(parts == plan.width * plan.height, "units are all of it");
});

const Registered units("unit", [](std::string_view input) {
  work::Plan plan;
  plan.width = plan.height = plan.unit_width = plan.unit_height = 1;
  plan.key = io::sha256("plan");
  const std::string head = "brdf-unit 1 " + plan.key + " 0 " + io::sha256(input) + "\n";
  const fs::path job = folder_with("job", "units/000/00000.unit", head + std::string(input));
  const auto files = work::read_unit(job, plan, 0);
  require((work::state_of(job, plan, 0) == work::UnitState::done) == files.has_value(),
          "what is done can be read");
  if (!files) return;
  std::size_t bytes = 0;
  for (const work::UnitFile& file : *files) {
    bytes += file.name.size() + file.bytes.size();
    const fs::path there = ("/folder" / fs::path(file.name)).lexically_normal();
    require(there.string().starts_with("/folder/"), "files lie in the folder that they are put in");
  }
  require(bytes <= input.size(), "no byte is there twice");
  work::write_unit(job, plan, 0, *files);
  const auto again = work::read_unit(job, plan, 0);
  require(again && again->size() == files->size(), "what is written can be read");
  for (std::size_t k = 0; k < files->size(); ++k)
    require((*again)[k].name == (*files)[k].name && (*again)[k].bytes == (*files)[k].bytes,
            "a unit reads back as it was written");
});

}  // namespace
}  // namespace brdf::fuzz
