// A font file opened by FreeType, for text as outlines (mesh/text.cpp) and as pixels (canvas.cpp).
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

struct FT_LibraryRec_;
struct FT_FaceRec_;

namespace brdf::render {

class Font {
 public:
  static constexpr const char* kBold = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";
  static constexpr const char* kPlain = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

  // Throws EnvironmentError if the font cannot be read.
  explicit Font(const std::filesystem::path& file);
  FT_FaceRec_* face() const { return face_.get(); }

 private:
  struct LibraryCloser {
    void operator()(FT_LibraryRec_* library) const;
  };
  struct FaceCloser {
    void operator()(FT_FaceRec_* face) const;
  };
  std::unique_ptr<FT_LibraryRec_, LibraryCloser> library_;
  std::unique_ptr<FT_FaceRec_, FaceCloser> face_;
};

// Returns the code points of UTF-8 text. Throws InputError on a malformed byte.
std::vector<char32_t> code_points(std::string_view text);

}  // namespace brdf::render
