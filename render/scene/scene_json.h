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
// Reads the name of an enumerator. Throws InputError with the known names for any other text.
template <class Enum>
Enum read_named(const io::JsonPlace& place) {
  const std::optional<Enum> found = find_named<Enum>(place.text());
  if (!found) place.fail("must be one of " + known_names<Enum>());
  return *found;
}

}  // namespace brdf::render
