// Reads the tensor files of the RGL material database (Dupuy and Jakob 2018, "An adaptive parameterization
// for efficient material acquisition and rendering"): RGB and spectral files, isotropic and anisotropic.
#pragma once

#include <memory>
#include <span>

#include "brdf/vec3.h"
#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io::rgl {

// Returns whether the content begins as a tensor file.
bool recognises(const Content& content);

// A measured BRDF. Between the measured directions its values follow the interpolation of the format.
class Measurement {
 public:
  // Throws InputError if the file is damaged.
  explicit Measurement(const Content& content);
  ~Measurement();

  // Evaluates f_r cos_o per channel, in 1/sr, for unit directions above the horizon. Negative values, which
  // arise when a file is converted to RGB, become 0.
  void eval_cos_o(const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> out) const;

  const std::string& description() const;
  const std::vector<std::string>& channels() const;  // r, g, b, or bands: 379.98nm, ...
  bool isotropic() const;
  // Returns the symmetry in azimuth: 2 if rotating both directions by half a turn changes nothing, 4 if
  // mirroring them changes nothing either, otherwise 1.
  int symmetry() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

// Samples f_r of the file, densely enough to fit the canonical forms. theta_i is 5, 15, 30, 45, 60 and 75
// degrees; theta_o is 0 to 80 in steps of 4. If the file is isotropic, phi_i is 180 and phi_o is 0 to 180
// in steps of 10, which covers half of the hemisphere. If the file is anisotropic, phi_i runs in steps of
// 30 from 180 over the part of the circle that the file holds (a quarter, half or all), and phi_o is 0 to
// 345 in steps of 15. Directions for which the tables leave the value undefined (a density of 0) are left
// out and counted. `supplied` must agree with the format about values and azimuths. Throws InputError for a
// disagreement, and if the file is damaged or holds no finite value.
// Example:
//     const brdf::io::Content content = brdf::io::read_content("copper.bsdf");
//     const brdf::io::rgl::Measurement copper(content);  // interpolated by the rule of the format
//     const brdf::io::SampleTable table = brdf::io::rgl::read(content);  // rows for a fit
//     std::printf("%s: %zu rows\n", copper.description().c_str(), table.rows());
SampleTable read(const Content& content, const Supplied& supplied = {});

}  // namespace brdf::io::rgl
