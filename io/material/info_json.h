// What a reflectance says of itself, as `brdf models --json` lists it.
#pragma once

#include "brdf/reflectance.h"
#include "io/files/json.h"

namespace brdf::io {

// `{"form", "family", "fittable", "canonical", "parameters": [{"name", "kind", "role", "min", ...}],
// "known_violations"}`.
Json to_json(const ReflectanceInfo& form);

}  // namespace brdf::io
