#include "render/text/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include <utf8.h>

#include <iterator>
#include <string>

#include "io/files/error.h"
#include "io/files/installed.h"

namespace brdf::render {
namespace {

std::filesystem::path font_file(const std::string& name) {
  const std::filesystem::path of_system = "/usr/share/fonts/truetype/dejavu/" + name;
  const std::filesystem::path of_program = io::installed_file("brdf/fonts/" + name);
  return std::filesystem::exists(of_system) || of_program.empty() ? of_system : of_program;
}

}  // namespace

std::filesystem::path Font::bold() {
  return font_file("DejaVuSans-Bold.ttf");
}

std::filesystem::path Font::plain() {
  return font_file("DejaVuSans.ttf");
}

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
  if (FT_New_Face(library, file.c_str(), 0, &face))
    throw EnvironmentError("cannot read the font " + file.string() + " (Debian: fonts-dejavu-core)");
  face_.reset(face);
}

std::vector<char32_t> code_points(std::string_view text) {
  if (const auto bad = utf8::find_invalid(text.begin(), text.end()); bad != text.end())
    throw InputError("text: byte " + std::to_string(bad - text.begin() + 1) + " is not UTF-8");
  std::vector<char32_t> out;
  utf8::utf8to32(text.begin(), text.end(), std::back_inserter(out));
  return out;
}

}  // namespace brdf::render
