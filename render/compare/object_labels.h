// Draws the labels of objects.
#pragma once

#include "render/picture/picture.h"
#include "render/scene/prepared.h"

namespace brdf::render {

// Writes the label of each object that has a label below the object, as wide as the neighbouring labels
// permit.
void draw_object_labels(BytePicture& picture, const PreparedScene& scene);

}  // namespace brdf::render
