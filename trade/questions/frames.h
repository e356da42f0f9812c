// Questions with the unit "frame": shading modes, bits of the G-buffer, forward or deferred light, and the
// lookup texture.
#pragma once

#include "trade/questions/gallery.h"

namespace brdf::trade {

enum class FrameDetail { quick, full };  // size of the pictures, number of meshes
std::vector<FrameQuestion> frame_questions(FrameDetail detail);

}  // namespace brdf::trade
