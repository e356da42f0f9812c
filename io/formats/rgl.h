// The tensor files of the RGL material database (Dupuy and Jakob 2018, "An adaptive parameterization for
// efficient material acquisition and rendering"): RGB and spectral, isotropic and anisotropic ones.
#pragma once

#include <memory>
#include <span>

#include "brdf/vec3.h"
#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io::rgl {

bool recognises(const Content& content);

// The measured BRDF as its own interpolation gives it between the measured directions.
class Measurement {
 public:
  // Throws InputError where the file is damaged.
  explicit Measurement(const Content& content);
  ~Measurement();

  // f_r cos_o per channel in 1/sr for unit directions above the horizon; negative values, which the
  // conversion of a file to RGB produces, are 0.
  void eval_cos_o(const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> out) const;

  const std::string& description() const;
  const std::vector<std::string>& channels() const;  // r, g, b, or bands: 379.98nm, ...
  bool isotropic() const;
  // 2 where turning both directions by half a turn changes nothing, 4 where mirroring them does not either;
  // else 1.
  int symmetry() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

// f_r of the file at theta_i 5, 15, 30, 45, 60, 75, theta_o 0..80 in steps of 4, phi_o 0..180 in steps of 10
// degrees (phi_i = 180): enough to fit the canonical forms; half of the hemisphere where the file is
// isotropic. Of an anisotropic one phi_i in steps of 30 degrees over what the file holds (a quarter, half or
// all of the circle, from 180) and phi_o 0..345 in steps of 15. Directions where the tables leave the value
// undefined (a density of 0) are left out and counted.
// `supplied` may say nothing else of values and azimuths than the format does.
SampleTable read(const Content& content, const Supplied& supplied = {});

}  // namespace brdf::io::rgl
