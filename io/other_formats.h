// Files that are no table that is read, recognised by their content, with what to do about it.
#pragma once

#include <string>

#include "io/content.h"

namespace brdf::io {

// Refuses pictures, workbooks, archives, documents and the formats of other programs that are known but not
// read.
void refuse_other_formats(const Content& content);

// What a JSON text of another program is, by its keys, with the advice on it, as the end of a sentence about
// the file; empty if no keys of a table of samples are found.
std::string foreign_json(const Content& content);

}  // namespace brdf::io
