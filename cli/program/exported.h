// What `brdf export` writes: materials for other programs, shaders, tables and maps.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "cli/options/options.h"
#include "cli/verb.h"
#include "interop/programs.h"
#include "interop/rgl.h"
#include "io/columns/supplied.h"
#include "io/files/json.h"

namespace brdf::cli {

struct ExportCall {
  MaterialOptions material;
  std::string measured, maps, loss_map, to, output, name, kernels = "own", table_layout = "brdf";
  bool include = false, naive = false, json = false, is_positional = false;
  std::optional<double> max_loss;
  io::Supplied supplied;
  std::uint64_t size = interop::kUsualTable;
  std::function<void(const std::string&)> step;  // shows the current step on a terminal
};

inline constexpr const char *kMerl = "merl", *kRgl = "rgl";

// Additional content of --json, and the exit code.
struct Made {
  io::Json json;
  Exit exit = Exit::good;
};

// Writes the file, or the text to stdout, and reports the loss. `program` is null for shaders and tables.
// Throws InputError for options and materials that do not suit the target, and interop::Refused for
// properties that the target cannot hold.
Made made_by(const ExportCall& o, const interop::Program* program);

}  // namespace brdf::cli
