#include "io/content.h"

#include <fstream>

namespace brdf::io {

bool is_json(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  char first = 0;
  return (in >> first) && first == '{';
}

}  // namespace brdf::io
