// The programs that materials can be exported to.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interop/project.h"

namespace brdf::interop {

// A projected term, in the frame of its wider axis.
struct WrittenPart {
  const Term& term;
  Angle tangent;  // azimuth of the wider axis in the surface's frame
  Angle given;    // azimuth of the material's alpha_x axis
};

// Input of a writer: the parts, which add up to the projected material, and the header of the file.
struct Written {
  std::vector<WrittenPart> parts;
  std::string name;                 // name of the material
  std::vector<std::string> header;  // lines: source, loss, conventions
};

// A program, with the limits of its files and the formulas that it offers.
struct Program {
  std::string_view name;   // value of --to
  std::string_view title;  // title for messages
  // Upper limits of weights, and of the lobe's weight: the program clamps larger ones.
  double most, most_lobe;
  bool adds;  // files of the program hold sums of any number of lobes
  // True if a test runs the program on the files. Otherwise tests only check the program's formula.
  bool run_here;
  std::vector<std::string> conventions;
  std::vector<TargetRules> targets;  // the target with the smallest loss is written
  // Throws InputError for values outside the range of the program's controls.
  std::string (*write)(const Written&);
};

// Returns all programs.
std::span<const Program> programs();
// Returns the row of glTF, for a program that writes no other file: it then contains no other writer.
const Program& gltf();
// Returns the program with this name, or null if there is no such program.
const Program* find_program(std::string_view name);

// Returns the limits of the program's files.
Limits limits_of(const Program& program);

// Returns a projected term as options of other verbs: "--form NAME --set ...".
std::string as_command(const Term& term, Angle tangent = {});

// A target that was refused, with the reason.
struct Refusal {
  std::string target, reason;
};

// A material written for a program.
struct Exported {
  std::string text;
  Material carried;   // the material that the program computes from the text, in the surface's frame
  Loss loss, copied;  // loss of `carried`; loss of the copied parameters (--naive)
  bool refitted = false;
  std::string target;               // name of the target form
  std::vector<std::string> header;  // same lines as in the text
  // Options that make other verbs evaluate the projected material: "--form NAME --set ...", one entry per
  // term. The values of the terms add up.
  std::vector<std::string> words;
  // True if these options give the values of the form, but the program renders other values
  // (TargetRules::shown).
  bool by_channel = false;
  std::vector<std::string> not_held{};  // properties that the target cannot hold, a sentence each
  std::vector<Refusal> refused{};       // the other targets of the program that were refused

  // True if the program computes the form of the material itself, with the same parameters. Only this is
  // called exact: a search that finds no difference proves nothing about the directions between its own.
  bool is_same = false;
};

// Returns "exact", "no difference above 1e-9 at ...", or "refitted: largest ...; copied parameters: largest
// ...".
std::string in_words(const Exported& made);

// Writes the material as text for this program. Throws Refused if the program cannot carry the material.
Exported export_to(const Program& program, const Material& material, const std::string& name, bool naive);

}  // namespace brdf::interop
