// What a file holds, by its content: names say nothing.
#pragma once

#include <filesystem>

namespace brdf::io {

// Whether the first character that is no blank opens a JSON object. False where the file cannot be opened.
bool is_json(const std::filesystem::path& path);

}  // namespace brdf::io
