// Pictures of a fitted material in the studio, and of the material and its samples under one light.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "io/page/sphere/still.h"
#include "measured/measured.h"
#include "study/lobes.h"

namespace brdf::study {

struct Spheres {
  io::sphere::StudioPictures studio;  // the fitted material in the studio
  io::sphere::Stills whole;           // under one light
  std::vector<Lobe> lobes;
  std::string missing;  // the reason why there are no pictures; empty if there are pictures
  // The samples as drawn, for the interactive sphere of a page.
  std::shared_ptr<const measured::MeasuredReflectance> seen;
};

// Draws the pictures. If the channels are not colours, there are no pictures, and Spheres::missing gives
// this reason. If `stops` returns true in between, the pictures are incomplete.
Spheres draw(const io::SampleTable& samples, const Material& fitted, const std::function<bool()>& stops);

}  // namespace brdf::study
