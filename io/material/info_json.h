// Writes the description of a reflectance as `brdf models --json` lists it.
#pragma once

#include "brdf/reflectance.h"
#include "io/files/json.h"

namespace brdf::io {

// Returns `{"form", "family", "fittable", "canonical", "parameters": [{"name", "kind", "role", "min",
// ...}], "known_violations"}`.
Json to_json(const ReflectanceInfo& form);

}  // namespace brdf::io
