// Spheres of a material and of its samples, where this build and this machine can draw.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "brdf/material.h"

namespace brdf::study {

// PNG files' bytes, under the same light; empty where there is none.
struct Spheres {
  std::string measured, fitted, difference;
  std::string small_measured, small_fitted;
  std::vector<std::string> notes;  // how channels became colours, where their names do not say it
  std::string missing;             // why there are none
};

// Draws one study's spheres at a time, on whichever thread asks.
class Painter {
 public:
  Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;
  ~Painter();

  // Whether there are a renderer and a driver; asked once.
  bool can_draw();
  // What is missing, a renderer, a driver, colours or samples that can be read again, is said in Spheres::missing.
  // Throws as io::read_samples() where they cannot be read all the same.
  Spheres draw(const std::filesystem::path& samples, const std::string& name, const Material& material);

 private:
  class Studio;
  std::unique_ptr<Studio> studio_;
};

}  // namespace brdf::study
