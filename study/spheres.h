// Pictures of a material and of its samples, under the same light.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/page/sphere/still.h"
#include "measured/measured.h"
#include "study/lobes.h"

namespace brdf::study {

struct Spheres {
  io::sphere::Stills whole, small;
  std::vector<Lobe> lobes;
  std::string missing;  // why there are no pictures
  // The samples as they were drawn, for what a page turns.
  std::shared_ptr<const measured::MeasuredReflectance> seen;
};

// Channels that are no colours have none: Spheres::missing says so.
Spheres draw(const io::SampleTable& samples, const Material& fitted);

}  // namespace brdf::study
