// Writes a page with two spheres: a fitted material next to a true material that is measured up to 70
// degrees, and the fitted material alone. Usage: sphere_page FITTED TRUE FILE
#include <cstdio>

#include "io/files/content.h"
#include "io/files/output.h"
#include "io/material/material_file.h"
#include "io/page/sphere/page.h"

int main(int argc, char** argv) {
  using namespace brdf;
  if (argc != 4) {
    std::fprintf(stderr, "usage: sphere_page FITTED TRUE FILE\n");
    return 2;
  }
  const Material fitted = io::read_material(io::read_content(argv[1]));
  const auto measured = [truth = io::sphere::fitted_pairs(io::read_material(io::read_content(argv[2])))](
                            const Vec3<double>& wi,
                            const Vec3<double>& wo) -> std::optional<io::sphere::Colour> {
    if (wi.z < 0.342 || wo.z < 0.342) return std::nullopt;
    return truth(wi, wo);
  };
  io::HtmlReport report("Spheres");
  io::sphere::add(report, {.title = "two lobes, fitted by one", .fitted = fitted, .measured = measured});
  io::sphere::add(report, {.title = "one lobe", .fitted = fitted});
  io::write_file_atomically(argv[3], report.document({"0", "sphere_page", {}}));
}
