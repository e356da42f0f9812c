#include "io/files/fingerprint.h"

#include <cstdint>
#include <sstream>

namespace brdf::io {

std::string fingerprint(std::initializer_list<std::string_view> texts) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::string_view text : texts)
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::ostringstream digits;
  digits << std::hex << hash;
  return digits.str();
}

}  // namespace brdf::io
