// Scenes as JSON: a file's, or one inside another document.
#pragma once

#include "io/files/json.h"
#include "render/scene/scene.h"

namespace brdf::render {

// `folder` is where relative file names start. Throws InputError with the whole place.
Scene scene_from_json(const io::JsonPlace& place, const std::filesystem::path& folder);
io::Json to_json(const Scene& scene);

// "format" and "version" 1 of a document.
void require_format(const io::JsonPlace& place, std::string_view format);
bool read_flag(const io::JsonPlace& place);
template <class Enum>
Enum read_named(const io::JsonPlace& place) {
  const std::optional<Enum> found = find_named<Enum>(place.text());
  if (!found) place.fail("must be one of " + known_names<Enum>());
  return *found;
}

}  // namespace brdf::render
