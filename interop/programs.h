// The programs that materials are written for.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interop/project.h"

namespace brdf::interop {

// What a writer is given: the projected material, seen from the frame of its wider axis, and what the file begins with.
struct Written {
  const Term& term;
  Angle tangent;
  std::string name;                 // of the material
  std::vector<std::string> header;  // lines: where it comes from, loss, conventions
};

struct Program {
  std::string_view name;   // as --to takes it
  std::string_view title;  // for people
  double most, most_lobe;  // a weight above, or one of the lobe, is clamped by the program
  bool run_here;           // a test runs the program on what is written; else its formula is checked, not run
  std::vector<std::string> conventions;
  std::vector<TargetRules> targets;  // the one of least loss is written
  // Throws InputError for what the program's controls do not reach.
  std::string (*write)(const Written&);
};

std::span<const Program> programs();
// By its name; null where there is none.
const Program* find_program(std::string_view name);

struct Refusal {
  std::string target, reason;
};

struct Exported {
  std::string text;
  Projection projection;
  std::string target;               // its name
  std::vector<std::string> header;  // as in the text
  std::string words;                // the projected material as other verbs take it: --form NAME --set ...
  std::vector<Refusal> refused{};   // of the program's other targets
};

// The material as this program's text. Throws Refused for what it cannot carry.
Exported export_to(const Program& program, const Material& material, const std::string& name, bool naive);

}  // namespace brdf::interop
