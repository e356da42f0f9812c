// Reads tables of all known formats.
#pragma once

#include <filesystem>
#include <string>

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Reads a table in any known format. The format is detected from the content, never from the suffix
// (docs/formats.md). Values of another quantity are converted to f_r. `supplied` states facts that the file
// does not state, and must not contradict the file. Every table that is read can be written: names, finite
// values and comments obey the rules of a CSV. Throws InputError with file, line and column.
// Example:
//     const brdf::io::SampleTable table = brdf::io::read_samples("paint.csv");
//     for (const std::string& warning : table.warnings) std::printf("%s\n", warning.c_str());
//     std::printf("%zu rows of %zu channels\n", table.rows(), table.channels.size());
SampleTable read_samples(const std::filesystem::path& path, const Supplied& supplied = {});
SampleTable read_samples(Content content, const Supplied& supplied = {});
// Returns the name of the format that a reader recognises: "merl", "klems", ..., "json" for JSON that no
// reader recognises, "csv" for any other text. Throws InputError for files of other kinds, as read_samples().
std::string format_name(Content content);
// Reads a table of directions in the same way; a CSV without any column of values is accepted.
SampleTable read_directions(const std::filesystem::path& path);
SampleTable read_directions(Content content);

}  // namespace brdf::io
