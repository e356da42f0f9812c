#pragma once

#include "render/picture/picture.h"
#include "render/scene/prepared.h"

namespace brdf::render {

// Writes the label of every object that has one below it, as wide as its neighbours leave room.
void draw_object_labels(BytePicture& picture, const PreparedScene& scene);

}  // namespace brdf::render
