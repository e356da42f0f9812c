// Estimates the noise of a mean of pictures from the spread of the pictures.
#pragma once

#include <vector>

#include "render/picture/picture.h"

namespace brdf::render {

class PictureSpread {
 public:
  PictureSpread(int width, int height);
  void add(const Picture& picture);
  // Returns the root mean square of the standard errors of the mean, over the mean of the surface. Pixels
  // count if every picture shows a surface there. The figure is an upper estimate if the pictures show
  // different places of the pixels, or continue one sequence of directions. Returns -1 for fewer than two
  // pictures, and 0 if there is no surface.
  double noise() const;

 private:
  struct Sums {
    glm::dvec3 values{0}, squares{0};
    int surface = 0;
  };
  std::vector<Sums> sums_;
  int count_ = 0;
};

// Returns the mean of a mean of `count` pictures and one more picture. The alpha value of the first is kept.
Picture weighted(const Picture& mean, double count, const Picture& one_more);

}  // namespace brdf::render
