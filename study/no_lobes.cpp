#include "study/lobes.h"

namespace brdf::study {

bool has_lobes() {
  return false;
}

std::vector<Lobe> lobes_of(const io::SampleTable&, const Material&) {
  return {};
}

}  // namespace brdf::study
