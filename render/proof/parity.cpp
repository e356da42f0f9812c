#include "render/proof/parity.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/gpu/held.h"
#include "render/gpu/renderer.h"
#include "render/reference/reference.h"

namespace brdf::render {
namespace {

constexpr double kNarrow = 0.05;

// Returns the value that makes the lobe as wide as a slope distribution of width kNarrow; std::nullopt for
// other parameters.
std::optional<double> narrow_value(const ParameterInfo& p) {
  if (p.map == Map::roughness) return std::sqrt(kNarrow);
  if (p.role == Role::width || p.role == Role::width_across) return kNarrow;
  if (p.role == Role::exponent || p.role == Role::exponent_across) return 2 / (kNarrow * kNarrow) - 2;
  return std::nullopt;
}

// Returns false if the form has no such parameter.
bool narrow(Term& term) {
  const std::span<const ParameterInfo> table = info(term.form).shape;
  bool changed = false;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const std::optional<double> value = narrow_value(table[k]);
    if (!value) continue;
    term.shape[0][k] = std::clamp(*value, table[k].min, table[k].max);
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
    for (const bool narrowed : {false, true}) {
      if (narrowed && !narrow(material.terms[0])) continue;
      Scene sphere = material_scene({{std::string(info(form).name), with_room(material)}});
      sphere.camera.width = sphere.camera.height = size;
      const PreparedScene scene = prepare(std::move(sphere));
      const Picture reference = render_reference(scene);
      for (const int bits : {16, 32}) {
        Renderer renderer(device, scene, {.gbuffer_bits = bits});
        renderer.draw();
        const Picture picture = picture_from(reference.width, reference.height, renderer.read_color());
        rows.push_back({std::string(info(form).name), narrowed ? "width 0.05" : "defaults", bits,
                        compare(picture, reference)});
        if (report) report(rows.back());
      }
    }
  }
  return rows;
}

}  // namespace brdf::render
