#pragma once

#include <cctype>
#include <string>

namespace brdf::io {

// A name as programs take it: letters, digits and _, not a digit first.
inline std::string identifier(const std::string& name) {
  std::string out;
  for (const char c : name) out += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  if (out.empty() || std::isdigit(static_cast<unsigned char>(out[0]))) out = "material_" + out;
  return out;
}

}  // namespace brdf::io
