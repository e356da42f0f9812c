// Metadata of tables that other programs keep as JSON.
#pragma once

#include "io/files/json.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Adds the members of a JSON object that are texts, numbers, or lists of texts as comments. Nested objects
// and empty texts are omitted.
void add_metadata(SampleTable& table, const Json& object);

}  // namespace brdf::io
