// The programs that materials are written for.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interop/project.h"

namespace brdf::interop {

// A projected term, seen from the frame of its wider axis.
struct WrittenPart {
  const Term& term;
  Angle tangent;  // azimuth of that axis in the surface's frame
  Angle given;    // azimuth of the axis of alpha_x, as the material has it
};

// What a writer is given: the projected material's parts, whose sum it is, and what the file begins with.
struct Written {
  std::vector<WrittenPart> parts;
  std::string name;                 // of the material
  std::vector<std::string> header;  // lines: where it comes from, loss, conventions
};

struct Program {
  std::string_view name;   // as --to takes it
  std::string_view title;  // for people
  double most, most_lobe;  // a weight above, or one of the lobe, is clamped by the program
  bool adds;               // its files hold sums of any number of lobes
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
  Material carried;   // what the program computes of the text, in the surface's frame
  Loss loss, copied;  // of that, and of what --naive writes
  bool refitted = false;
  std::string target;               // its name
  std::vector<std::string> header;  // as in the text
  // The projected material as other verbs take it, a term each: --form NAME --set ...; the values add up.
  std::vector<std::string> words;
  bool by_channel =
      false;  // these words have the form's values, and the program shows others (TargetRules::shown)
  std::vector<std::string> not_held{};  // what the target has no place for, a sentence each
  std::vector<Refusal> refused{};       // of the program's other targets

  bool exact() const { return loss.exact(); }
};

// "exact", or "refitted: largest ...; copied parameters: largest ...".
std::string in_words(const Exported& made);

// The material as this program's text. Throws Refused for what it cannot carry.
Exported export_to(const Program& program, const Material& material, const std::string& name, bool naive);

}  // namespace brdf::interop
