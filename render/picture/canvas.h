// Draws lines and text into a picture that becomes a PNG. Places are in pixels from the upper left corner.
#pragma once

#include <string>
#include <vector>

#include "render/picture/picture.h"

namespace brdf::render {

using ByteColor = std::array<std::uint8_t, 3>;

// Mixes a colour into the pixel by its share in [0, 1]; pixels outside the picture are ignored.
void blend(BytePicture& picture, int x, int y, ByteColor color, float share);
// Mixes a colour into a rectangle.
void fill(BytePicture& picture, glm::ivec2 corner, glm::ivec2 size, ByteColor color, float share = 1);
// Draws connected straight pieces with smooth edges; `width` in pixels.
void draw_path(BytePicture& picture, const std::vector<glm::vec2>& points, float width, ByteColor color);
// Draws a disc with a dark rim; `size` is its diameter in pixels.
void draw_dot(BytePicture& picture, glm::vec2 at, float size, ByteColor color, float share = 1);

// Text in one line; bytes that are not UTF-8 appear as a question mark. Threads may draw at the same time
// if each draws into its own picture. Throws EnvironmentError if the font (fonts-dejavu-core) is missing.
float text_width(const std::string& text, int pixels);
void draw_text(BytePicture& picture, glm::vec2 baseline, const std::string& text, int pixels,
               ByteColor color = {255, 255, 255});

// Returns the text unchanged if it is no wider than `width`, otherwise without its middle.
std::string elided(const std::string& text, int pixels, float width);
// Draws a picture's name in a lower corner: white text on a dark ground, at most `most` pixels wide (0: the
// width of the picture).
enum class Corner { left, right };
void draw_label(BytePicture& picture, const std::string& text, Corner corner = Corner::left, int most = 0);
// Returns the height of a label's letters in pixels: proportional to the picture, but legible.
// smallest_label() is the height for labels with much text.
int label_pixels(const BytePicture& picture);
int smallest_label(const BytePicture& picture);

}  // namespace brdf::render
