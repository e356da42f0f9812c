// The picture in which image errors are measured.
#pragma once

#include "render/reference/reference.h"
#include "trade/measure/question.h"

namespace brdf::trade {

// Returns a scene with one sphere under one directional light from the upper left front, size x size pixels.
render::Scene material_ball(int size);

PicturePoints picture_points(const std::vector<render::LitPoint>& lit, int width);

}  // namespace brdf::trade
