// Long work in units that any number of processes do: in any order, more than once, on any machine that sees
// the folder.
//
// JOB/plan.json says what is to be done, JOB/units/NNN/NNNNN.unit what came of unit NNNNN, as one file that
// is there as a whole or not at all. Whoever has all of them has the result: no clock, no lock and no
// scheduler is asked. What a unit does, and what its files hold, is the business of who works on it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "brdf/names.h"
#include "texel/planes.h"

namespace brdf::work {

struct Input {
  std::string file;  // as it was named
  std::uint64_t bytes = 0;
  std::string sha256;

  bool operator==(const Input&) const = default;
};

struct Plan {
  std::string verb;                   // what it does to its inputs: fit, study
  std::string stack;                  // the folder; empty where the inputs are tables
  std::vector<std::string> options;   // of the verb, word by word
  std::string command;                // that does the same at once
  std::string directory;              // in which the names are looked up
  std::size_t width = 0, height = 0;  // what is divided: texels; of tables as many as there are, and 1
  std::size_t unit_width = 0, unit_height = 0;  // of a unit
  std::vector<Input> inputs;                    // of tables in their order
  std::string version, key;                     // of the program; the SHA-256 of all that

  std::vector<texel::Region> units() const;
};

// Reads every input once; fills in version and key.
Plan completed(Plan plan, const std::vector<std::string>& inputs);

// Writes JOB/plan.json. The same plan again changes nothing. Throws InputError where the folder holds another
// one.
void write_plan(const std::filesystem::path& job, const Plan& plan);
// Throws InputError where there is none, it was changed, or another version of the program made it.
Plan read_plan(const std::filesystem::path& job);

// Throws InputError where an input is not as long as it was when the work was planned, or, where the content
// is asked for, not the same.
void check_input(const Input& input, bool content);

struct UnitFile {
  std::string name, bytes;
};

enum class UnitState { done, missing, damaged };

// Damaged: of another plan, too short, or not the bytes that were written.
UnitState state_of(const std::filesystem::path& job, const Plan& plan, std::size_t unit);
// What a unit's file holds; none where it is not done.
std::optional<std::vector<UnitFile>> read_unit(const std::filesystem::path& job, const Plan& plan,
                                               std::size_t unit);
// Throws as io::write_file_atomically().
void write_unit(const std::filesystem::path& job, const Plan& plan, std::size_t unit,
                const std::vector<UnitFile>& files);

// "3,7,12-19", as job arrays are asked for. Precondition: ascending.
std::string array_text(const std::vector<std::size_t>& units);

}  // namespace brdf::work

template <>
inline constexpr std::array<std::string_view, 3> brdf::kNames<brdf::work::UnitState>{"done", "missing",
                                                                                     "damaged"};
