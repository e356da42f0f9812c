#include "study/spheres.h"

namespace brdf::study {

class Painter::Studio {};

Painter::Painter() = default;
Painter::~Painter() = default;

bool Painter::can_draw() {
  return false;
}

Spheres Painter::draw(const std::filesystem::path&, const std::string&, const Material&) {
  return {.missing = "no renderer here: this build was made without it"};
}

}  // namespace brdf::study
