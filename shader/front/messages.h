// Turns the compiler's messages into sentences that name the file, the line and a remedy.
#pragma once

#include <string>
#include <vector>

#include "shader/front/glslang.h"
#include "shader/front/includes.h"

namespace brdf::shader {

// Takes the first error of the log, because later errors follow from it. Sets the message and its place.
void take_messages(Translated& out, const Files& files, const Source& source, const std::string& log,
                   const std::vector<std::string>& missing);

}  // namespace brdf::shader
