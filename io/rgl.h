// The tensor files of the RGL material database (Dupuy and Jakob 2018, "An adaptive parameterization for
// efficient material acquisition and rendering"), isotropic RGB ones.
#pragma once

#include <memory>

#include "brdf/vec3.h"
#include "io/samples.h"

namespace brdf::io::rgl {

bool recognises(const Content& content);

// The measured BRDF as its own interpolation gives it between the measured directions.
class Measurement {
 public:
  // Throws InputError where the file is damaged, or anisotropic or spectral (unsupported).
  explicit Measurement(const Content& content);
  ~Measurement();

  // f_r cos_o per channel (r, g, b) in 1/sr for unit directions above the horizon; negative values, which the
  // file's conversion to RGB produces, are 0.
  void eval_cos_o(const Vec3<double>& wi, const Vec3<double>& wo, double rgb[3]) const;

  const std::string& description() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

// f_r of the file at theta_i 5, 15, 30, 45, 60, 75, theta_o 0..80 in steps of 4, phi_o 0..180 in steps of 10
// degrees (phi_i = 180): enough to fit the canonical forms; half of the hemisphere, as the file is isotropic.
// Directions where the tables leave the value undefined (a density of 0) are left out and counted.
SampleTable read(const Content& content);

}  // namespace brdf::io::rgl
