// Scenes as JSON: from a file, or inside another document.
#pragma once

#include "io/files/json.h"
#include "render/scene/scene.h"

namespace brdf::render {

// Reads a scene. `folder` is the base of relative file names. Throws InputError with the full JSON path.
Scene scene_from_json(const io::JsonPlace& place, const std::filesystem::path& folder);
io::Json to_json(const Scene& scene);

// Checks "format" and "version" 1 of a document. Throws InputError.
void require_format(const io::JsonPlace& place, std::string_view format);
// Reads true or false. Throws InputError for any other value.
bool read_flag(const io::JsonPlace& place);

}  // namespace brdf::render
