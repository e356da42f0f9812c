// What `brdf export --json` says of an export (docs/export.schema.json).
#pragma once

#include "interop/programs.h"
#include "io/files/json.h"

namespace brdf::interop {

// kind, target, the loss and that of copied parameters, the words that give the same values here, what of the
// program's targets was refused.
io::Json to_json(const Program& program, const Exported& made);

}  // namespace brdf::interop
