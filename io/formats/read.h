// Which reader a table is for.
#pragma once

#include <filesystem>

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Reads a table in any known format, recognised by its content, never by its suffix (docs/formats.md). Throws
// InputError naming file, line and column. What is read can be written: names, finite values and comments are
// those of a CSV. Values of another quantity become f_r; `supplied` states what the file does not, and may
// not contradict it.
SampleTable read_samples(const std::filesystem::path& path, const Supplied& supplied = {});
SampleTable read_samples(Content content, const Supplied& supplied = {});
// The same for a table of directions: a CSV without any value column is accepted.
SampleTable read_directions(const std::filesystem::path& path);
SampleTable read_directions(Content content);

}  // namespace brdf::io
