#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace brdf::io {

// What every output says about its making. It holds no date and no output path, so the same command gives the
// same bytes wherever they are written.
struct Provenance {
  std::string version;
  std::string command;  // as given, quoted for a shell, without where to write and how many at a time
  std::optional<std::uint64_t> seed;
};

// Called once by main; programs that never call it have an empty command.
void record_command_line(int argc, const char* const* argv);

// For what one command planned and others do: outputs name this one.
void record_command(std::string command);

Provenance provenance(std::optional<std::uint64_t> seed = std::nullopt);

// The same as key and value ("brdf_version", "command", "seed"), for CSV headers and JSON objects.
std::vector<std::pair<std::string, std::string>> provenance_fields(const Provenance& made);

}  // namespace brdf::io
