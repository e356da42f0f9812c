#include "texel/transfer.h"

#include <cmath>

#include "io/files/text.h"

namespace brdf::texel {

double Transfer::decoded(double x) const {
  const double linear = !srgb          ? std::pow(x, gamma)
                        : x <= 0.04045 ? x / 12.92
                                       : std::pow((x + 0.055) / 1.055, 2.4);
  return white * linear;
}

std::optional<Transfer> transfer_named(const std::string& word) {
  Transfer out;
  if (word == "linear") return out;
  out.srgb = word == "srgb";
  if (out.srgb) return out;
  if (io::parse_number(word, out.gamma) && out.gamma >= 0.1 && out.gamma <= 10) return out;
  return std::nullopt;
}

}  // namespace brdf::texel
