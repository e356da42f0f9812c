// Long work in units that any number of processes do: in any order, more than once, on any machine that has
// access to the folder.
//
// JOB/plan.json describes the work, and JOB/units/NNN/NNNNN.unit holds the results of unit NNNNN in one
// file, which either exists completely or not at all. The results of all units are the result of the job. No
// clock, lock or scheduler is involved. The processing of a unit and the content of its files are defined by
// the code that uses this header.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "brdf/names.h"
#include "texel/planes.h"

namespace brdf::work {

// An input file with its fingerprint.
struct Input {
  std::string file;  // name as given
  std::uint64_t bytes = 0;
  std::string sha256;

  bool operator==(const Input&) const = default;
};

// The description of a job: its work, and the division into units.
struct Plan {
  std::string verb;                  // the action on the inputs: fit, study
  std::string stack;                 // folder of the stack; empty if the inputs are tables
  std::vector<std::string> options;  // options of the verb, word by word
  std::string command;               // the equivalent command without a plan
  std::string directory;             // folder to which the names are relative
  // The total: width and height in texels for a stack; the number of parts and 1 otherwise.
  std::size_t width = 0, height = 0;
  std::size_t unit_width = 0, unit_height = 0;  // size of a unit
  std::vector<Input> inputs;                    // tables in their order
  std::string version, key;                     // version of the program; SHA-256 of all members above

  std::vector<texel::Region> units() const;
};

// Completes the plan: adds the inputs, each of which is read once, and fills in version and key. Throws
// InputError if an input is missing or if the plan has too many units.
Plan completed(Plan plan, const std::vector<std::string>& inputs);

// Writes JOB/plan.json. Writing the same plan again changes nothing. Throws InputError if the folder holds a
// different plan.
void write_plan(const std::filesystem::path& job, const Plan& plan);
// Reads JOB/plan.json, also of another version of the program. Throws InputError if the file does not exist
// or was changed.
Plan read_plan(const std::filesystem::path& job);

// Checks an input against the plan. Throws InputError if the length of the file differs or, if `content` is
// true, its content.
void check_input(const Input& input, bool content);

// A file inside a unit's file.
struct UnitFile {
  std::string name, bytes;
};

enum class UnitState { done, missing, damaged };

// Returns the state of a unit. A file is damaged if it belongs to another plan or was made by another version
// of the program, is too short, or differs from the bytes that were written.
UnitState state_of(const std::filesystem::path& job, const Plan& plan, std::size_t unit);
// Returns the content of a unit's file, or std::nullopt unless the unit is done.
std::optional<std::vector<UnitFile>> read_unit(const std::filesystem::path& job, const Plan& plan,
                                               std::size_t unit);
// Writes a unit's file. Throws as io::write_file_atomically().
void write_unit(const std::filesystem::path& job, const Plan& plan, std::size_t unit,
                const std::vector<UnitFile>& files);

// Returns unit numbers in the syntax of job arrays: "3,7,12-19". Precondition: the numbers are ascending.
std::string array_text(const std::vector<std::size_t>& units);

}  // namespace brdf::work

template <>
inline constexpr std::array<std::string_view, 3> brdf::kNames<brdf::work::UnitState>{"done", "missing",
                                                                                     "damaged"};
