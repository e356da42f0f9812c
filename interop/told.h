// The JSON of an export by `brdf export --json` (docs/export.schema.json).
#pragma once

#include "interop/programs.h"
#include "io/files/json.h"

namespace brdf::interop {

// Returns the kind, the target, the loss, the loss of copied parameters, the options that reproduce the
// values in brdf, and the refused targets of the program.
io::Json to_json(const Program& program, const Exported& made);

}  // namespace brdf::interop
