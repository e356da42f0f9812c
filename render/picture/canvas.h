// Lines and words drawn into a picture on its way to a PNG. Places in pixels from the upper left corner.
#pragma once

#include <string>
#include <vector>

#include "render/picture/picture.h"

namespace brdf::render {

using ByteColor = std::array<std::uint8_t, 3>;

// Mixes a colour into the pixel by its share in [0, 1]; outside the picture nothing happens.
void blend(BytePicture& picture, int x, int y, ByteColor color, float share);
void fill(BytePicture& picture, glm::ivec2 corner, glm::ivec2 size, ByteColor color, float share = 1);
// Straight pieces with smooth edges, one after another.
void draw_path(BytePicture& picture, const std::vector<glm::vec2>& points, float width, ByteColor color);
// A disc with a dark rim; `size` across.
void draw_dot(BytePicture& picture, glm::vec2 at, float size, ByteColor color, float share = 1);

// Text in one line; bytes that are no UTF-8 show as a question mark. Threads may draw at the same time, into
// pictures of their own. Throws EnvironmentError without the font (fonts-dejavu-core).
float text_width(const std::string& text, int pixels);
void draw_text(BytePicture& picture, glm::vec2 baseline, const std::string& text, int pixels,
               ByteColor color = {255, 255, 255});

// The text where it is no wider, else with its middle left out.
std::string elided(const std::string& text, int pixels, float width);
// White words on a dark ground in a lower corner, at most `most` pixels wide (0: as the picture): a picture's
// name.
enum class Corner { left, right };
void draw_label(BytePicture& picture, const std::string& text, Corner corner = Corner::left, int most = 0);
// The height of a label's letters: in proportion to the picture, and legible; and that of one with many
// words.
int label_pixels(const BytePicture& picture);
int smallest_label(const BytePicture& picture);

}  // namespace brdf::render
