#include "render/compare/picture_spread.h"

#include <cmath>

namespace brdf::render {

PictureSpread::PictureSpread(int width, int height) : sums_(std::size_t(width) * std::size_t(height)) {}

void PictureSpread::add(const Picture& picture) {
  ++count_;
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    if (!is_surface(picture.pixels[k])) continue;
    const glm::dvec3 value(picture.pixels[k]);
    sums_[k].values += value;
    sums_[k].squares += value * value;
    ++sums_[k].surface;
  }
}

double PictureSpread::noise() const {
  if (count_ < 2) return -1;
  const double n = count_;
  double variances = 0, mean = 0, pixels = 0;
  for (const Sums& pixel : sums_) {
    if (pixel.surface < count_) continue;
    const glm::dvec3 middle = pixel.values / n, spread = pixel.squares / n - middle * middle;
    for (int c = 0; c < 3; ++c) variances += std::max(spread[c], 0.0) / (n - 1);
    mean += middle.r + middle.g + middle.b;
    ++pixels;
  }
  return mean > 0 ? std::sqrt(variances / (3 * pixels)) / (mean / (3 * pixels)) : 0;
}

Picture weighted(const Picture& mean, double count, const Picture& one_more) {
  Picture out = mean;
  const auto share = float(1 / (count + 1));
  for (std::size_t k = 0; k < out.pixels.size(); ++k) {
    const float alpha = out.pixels[k].a;
    out.pixels[k] = glm::mix(mean.pixels[k], one_more.pixels[k], share);
    out.pixels[k].a = alpha;
  }
  return out;
}

}  // namespace brdf::render
