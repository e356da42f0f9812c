#include "render/text/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <string>

#include "io/error.h"

namespace brdf::render {

void Font::LibraryCloser::operator()(FT_LibraryRec_* library) const {
  FT_Done_FreeType(library);
}

void Font::FaceCloser::operator()(FT_FaceRec_* face) const {
  FT_Done_Face(face);
}

Font::Font(const std::filesystem::path& file) {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library)) throw EnvironmentError("FreeType cannot be started");
  library_.reset(library);
  FT_Face face = nullptr;
  if (FT_New_Face(library, file.c_str(), 0, &face)) {
    throw EnvironmentError("cannot read the font " + file.string() + " (Debian: fonts-dejavu-core)");
  }
  face_.reset(face);
}

std::vector<char32_t> code_points(std::string_view text) {
  std::vector<char32_t> out;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const int length = lead < 0x80         ? 1
                       : (lead >> 5) == 6  ? 2
                       : (lead >> 4) == 14 ? 3
                       : (lead >> 3) == 30 ? 4
                                           : 0;
    char32_t code = length == 1 ? lead : lead & (0xffu >> (length + 1));
    bool good = length > 0 && i + std::size_t(length) <= text.size();
    for (int k = 1; good && k < length; ++k) {
      const auto byte = static_cast<unsigned char>(text[i + std::size_t(k)]);
      good = (byte >> 6) == 2;
      code = (code << 6) | (byte & 0x3f);
    }
    if (!good) throw InputError("text: byte " + std::to_string(i + 1) + " is not UTF-8");
    out.push_back(code);
    i += std::size_t(length);
  }
  return out;
}

}  // namespace brdf::render
