#include "interop/rgl.h"

#include "interop/wanted.h"
#include "io/formats/rgl_writer.h"

namespace brdf::interop {

std::string rgl_of(const Material& material, const std::string& description, std::uint64_t bytes) {
  if (is_anisotropic(material))
    throw Refused("--to rgl: the material is anisotropic, but the file is written for a single azimuth");
  const io::rgl::Values values = [&](const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> f) {
    brdf::eval(material, wi, wo, f);
  };
  return io::rgl::file_of(values, material.channels, {description, bytes});
}

}  // namespace brdf::interop
