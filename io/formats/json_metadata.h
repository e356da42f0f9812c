// Metadata of tables that other programs keep as JSON.
#pragma once

#include <filesystem>

#include "io/files/json.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Adds the members of a JSON object that are texts, numbers, or lists of texts as comments. Nested objects
// and empty texts are omitted.
void add_metadata(SampleTable& table, const Json& object);

// Returns an identifier in the form of a UUID that follows from the content (version 8: of the writer's own
// making).
std::string identifier_of(const std::string& content);

// Writes the JSON of a table. Throws InputError, which names the table, if the text exceeds kLargestJson and
// could therefore not be read back.
void write_json_table(const std::filesystem::path& path, const Json& json, const SampleTable& table);

}  // namespace brdf::io
