// Recognises files by their content that are not supported as tables, and explains the remedy.
#pragma once

#include "io/files/content.h"

namespace brdf::io {

// Throws InputError for pictures, workbooks, archives, documents and the formats of other programs that are
// known but not read. The message states the format and the remedy.
void refuse_other_formats(const Content& content);

}  // namespace brdf::io
