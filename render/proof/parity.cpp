#include "render/proof/parity.h"

#include <cmath>

#include "render/gpu/renderer.h"
#include "render/reference/reference.h"

namespace brdf::render {
namespace {

constexpr double kNarrow = 0.05;

// Sets what makes the lobe as wide as alpha; false where the form has no such parameter.
bool narrow(Term& term) {
  const ReflectanceInfo& form = info(term.form);
  bool changed = false;
  for (std::size_t k = 0; k < form.shape.size(); ++k) {
    const std::string_view name = form.shape[k].name;
    double value = 0;
    if (name == "alpha_x" || name == "alpha_y") value = kNarrow;
    if (name == "roughness") value = std::sqrt(kNarrow);
    if (name == "exponent") value = 2 / (kNarrow * kNarrow) - 2;
    if (value == 0) continue;
    term.shape[0][k] = value;
    changed = true;
  }
  return changed;
}

}  // namespace

double parity_bound(int gbuffer_bits) {
  return gbuffer_bits == 32 ? 1e-11 : 1e-6;
}

bool passes(const ParityRow& row) {
  return row.difference.rel_mse < parity_bound(row.gbuffer_bits) &&
         row.difference.coverage_mismatch <= kMostCoverageMismatch;
}

std::vector<ParityRow> parity(Device& device, const std::vector<Reflectance>& forms, int size,
                              const std::function<void(const ParityRow&)>& report) {
  std::vector<ParityRow> rows;
  for (const Reflectance& form : forms) {
    Material material = make_material(form);
    for (const char* parameters : {"defaults", "alpha=0.05"}) {
      if (parameters[0] == 'a' && !narrow(material.terms[0])) continue;
      Scene sphere = material_scene({{std::string(info(form).name), material}});
      sphere.camera.width = sphere.camera.height = size;
      const PreparedScene scene = prepare(std::move(sphere));
      const Picture reference = render_reference(scene);
      for (const int bits : {16, 32}) {
        Renderer renderer(device, scene, {.gbuffer_bits = bits});
        renderer.draw();
        const Picture picture = picture_from(reference.width, reference.height, renderer.read_color());
        rows.push_back({std::string(info(form).name), parameters, bits, compare(picture, reference)});
        if (report) report(rows.back());
      }
    }
  }
  return rows;
}

}  // namespace brdf::render
