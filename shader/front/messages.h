// The compiler's messages, in sentences that say which file, which line and what to do.
#pragma once

#include <string>
#include <vector>

#include "shader/front/glslang.h"
#include "shader/front/includes.h"

namespace brdf::shader {

// The first error of the log: others follow from it. Sets the message and its place.
void take_messages(Translated& out, const Files& files, const Source& source, const std::string& log,
                   const std::vector<std::string>& missing);

}  // namespace brdf::shader
