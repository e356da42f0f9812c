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
  // Return the files of DejaVu Sans: of the system, or else the files installed with the program.
  static std::filesystem::path bold();
  static std::filesystem::path plain();

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
