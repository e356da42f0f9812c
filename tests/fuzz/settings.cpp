// The first line is the name of a form, and each further line is an argument of --set.
#include <sstream>

#include "io/material/material_file.h"
#include "io/material/settings.h"
#include "tests/fuzz/fuzz.h"

namespace brdf::fuzz {
namespace {

const Registered settings("settings", [](std::string_view input) {
  std::istringstream lines{std::string(input)};
  io::MaterialChoice choice;
  std::getline(lines, choice.form);
  for (std::string line; std::getline(lines, line);) choice.set.push_back(line);
  const Material material = io::choose_material(choice);
  io::check_material(material, "settings");
  check_material(material);
});

}  // namespace
}  // namespace brdf::fuzz
