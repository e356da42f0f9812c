#include "study/spheres.h"

namespace brdf::study {

bool can_draw() {
  return false;
}

Spheres draw(const io::SampleTable&, const Material&) {
  return {.missing = "no renderer here: this build was made without it"};
}

}  // namespace brdf::study
