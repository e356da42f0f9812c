// Pictures put together for one PNG: side by side, A|B, false colours with their numbers, the seven targets.
#pragma once

#include <string>
#include <vector>

#include "render/picture/picture.h"

namespace brdf {
namespace render {

class Renderer;

// What the viewer can show, and `brdf render` too.
enum class Display { picture, split, flip, difference, gbuffer };

// Two linear pictures of one size and how they are shown.
struct Comparison {
  const Picture* a = nullptr;  // one sample a pixel: what the difference is taken of
  const Picture* b = nullptr;
  const Picture* fine_a = nullptr;  // the same as they are shown; null: no other
  const Picture* fine_b = nullptr;
  Rounding rounding = Rounding::nearest;
  std::string name_a, name_b;
  Difference difference;
  ToneMap tone_map = ToneMap::srgb;
  float exposure = 0;
  float split = 0.5f;     // share of the width that shows A
  bool measured = false;  // B was measured: the difference is signed, up to 50 %
  bool labels = true;
};

// split: A, a line, B; flip: B; difference: false colours, with the scale and the measures where labelled;
// otherwise A. Names that do not fit beside each other lose their middle.
BytePicture arranged(const Comparison& comparison, Display display);
// A, B and the difference in one row.
BytePicture beside(const Comparison& comparison);

// Pictures of one size, named where there are names, in rows of so many.
BytePicture sheet(std::vector<BytePicture> pictures, const std::vector<std::string>& names, int columns);

// The seven targets as they are shown (vectors as v/2 + 1/2, position relative to its object's extent) and
// the lighting, in two rows.
BytePicture target_sheet(Renderer& renderer, bool labels);

}  // namespace render

template <>
inline constexpr std::array<std::string_view, 5> kNames<render::Display>{"picture", "split", "flip",
                                                                         "difference", "gbuffer"};

}  // namespace brdf
