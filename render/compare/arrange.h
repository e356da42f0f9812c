// Arranges pictures for one PNG: side by side, split between A and B, false colours with their numbers, or
// the seven targets.
#pragma once

#include <string>
#include <vector>

#include "render/picture/picture.h"

namespace brdf {
namespace render {

class Renderer;

// The displays of the viewer and of `brdf render`.
enum class Display { picture, split, flip, difference, gbuffer };

// Two linear pictures of the same size, and the settings for showing them.
struct Comparison {
  // Pictures with one sample per pixel, from which the difference is computed.
  const Picture* a = nullptr;
  const Picture* b = nullptr;
  // Samples of the pictures that are shown; null: `a` and `b` are shown.
  const Picture* fine_a = nullptr;
  const Picture* fine_b = nullptr;
  Rounding rounding = Rounding::nearest;
  std::string name_a, name_b;
  Difference difference;
  ToneMap tone_map = ToneMap::srgb;
  float exposure = 0;
  float split = 0.5f;  // share of the width that shows A
  // B is measured: the difference is signed and its scale ends at 50 %.
  bool measured = false;
  bool labels = true;
};

// Returns the picture of a display. split: A, a line, B; flip: B; difference: false colours, with the scale
// and the measures if `labels` is set; otherwise A. Names that do not fit next to each other lose their
// middle.
BytePicture arranged(const Comparison& comparison, Display display);
// Returns A, B and the difference in one row.
BytePicture beside(const Comparison& comparison);

// Returns pictures of the same size in rows of `columns`. Each picture gets its name as a label if `names`
// is not empty.
BytePicture sheet(std::vector<BytePicture> pictures, const std::vector<std::string>& names, int columns);

// Returns the seven targets as they are shown (vectors as v/2 + 1/2, the position relative to the extent of
// its object) and the lighting, in two rows.
BytePicture target_sheet(Renderer& renderer, bool labels);

}  // namespace render

template <>
inline constexpr std::array<std::string_view, 5> kNames<render::Display>{"picture", "split", "flip",
                                                                         "difference", "gbuffer"};

}  // namespace brdf
