#include "texel/transfer.h"

#include <cmath>

#include "io/colour/srgb.h"
#include "io/files/text.h"

namespace brdf::texel {

double Transfer::decoded(double x) const {
  return white * (srgb ? io::srgb_decoded(x) : std::pow(x, gamma));
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
