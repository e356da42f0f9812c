// The origin of an output: version, command and seed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace brdf::io {

// The record that every output contains about its origin. The record has no date and no output path, so
// that the same command gives the same bytes wherever its output is written.
struct Provenance {
  std::string version;
  // As given, quoted for a shell, without the options for the output's place and for the number of jobs.
  std::string command;
  std::optional<std::uint64_t> seed;
};

// Records the command line. Called once by main; in programs that never call this function the command is
// empty.
void record_command_line(int argc, const char* const* argv);

// Records the command that outputs name. Used by work that one command plans and other processes perform:
// their outputs name the planning command.
void record_command(std::string command);

// Returns the record of the running program.
Provenance provenance(std::optional<std::uint64_t> seed = std::nullopt);

// Returns the record as pairs of key and value ("brdf_version", "command", "seed"), for CSV headers and
// JSON objects.
// Example:
//     brdf::io::record_command("my_program paint.csv");
//     for (const auto& [key, value] : provenance_fields(brdf::io::provenance()))
//       std::printf("# %s: %s\n", key.c_str(), value.c_str());
std::vector<std::pair<std::string, std::string>> provenance_fields(const Provenance& made);

}  // namespace brdf::io
