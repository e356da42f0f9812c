// The meaning of the numbers in an image.
#pragma once

#include <optional>
#include <string>

namespace brdf::texel {

// The meaning of the numbers in a PNG, which are scaled to a largest number of 1. They are decoded with
// sRGB's curve (IEC 61966-2-1) or a power, then multiplied by `white`. OpenEXR images hold the values
// themselves.
struct Transfer {
  bool srgb = false;
  double gamma = 1;  // 1: linear
  double white = 1;  // 1/sr

  // Returns the value, in 1/sr, of the number x in [0, 1].
  double decoded(double x) const;
};

// Returns the transfer for "linear", "srgb" or a power from 0.1 to 10; std::nullopt for other words.
std::optional<Transfer> transfer_named(const std::string& word);

}  // namespace brdf::texel
