// Files that are no table that is read, recognised by their content, with what to do about it.
#pragma once

#include <string>

#include "io/files/content.h"

namespace brdf::io {

// Refuses pictures, workbooks, archives, documents and the formats of other programs that are known but not
// read.
void refuse_other_formats(const Content& content);

}  // namespace brdf::io
