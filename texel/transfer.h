// What the numbers of an image mean.
#pragma once

#include <optional>
#include <string>

namespace brdf::texel {

// What the numbers of a PNG mean, whose largest is 1: by sRGB's curve (IEC 61966-2-1) or to this power, then
// times `white`. OpenEXR holds the values themselves.
struct Transfer {
  bool srgb = false;
  double gamma = 1;  // 1: linear
  double white = 1;  // 1/sr

  double decoded(double x) const;
};

// "linear", "srgb" or a power from 0.1 to 10; none where it is no such word.
std::optional<Transfer> transfer_named(const std::string& word);

}  // namespace brdf::texel
