#include "micro/model.h"

#include <stdexcept>
#include <string>

#include "brdf/facets.h"

namespace brdf::micro {
namespace {

Reflectance required(const std::optional<Reflectance>& form, const char* what) {
  if (!form) throw std::invalid_argument(std::string("the catalogue has no form of ") + what);
  return *form;
}

bool by_slope_angle(const ReflectanceInfo& form) {
  return form.shape_index(Role::slope) >= 0 && form.weight_index(Role::specular) < 0;
}

}  // namespace

Reflectance form_of_rough_mirrors() {
  constexpr const FacetFacts* kFacets = &Facets<BeckmannSlopes, SmithBeckmann>::facts;
  return required(find_form_if([](const ReflectanceInfo& f) { return f.facets == kFacets; }),
                  "Gaussian slopes with Smith's masking");
}
Reflectance form_of_mirror_grooves() {
  constexpr const FacetFacts* kFacets = &Facets<BeckmannSlopes, VCavities>::facts;
  return required(find_form_if([](const ReflectanceInfo& f) {
                    return f.facets == kFacets && f.shape_index(Role::index) >= 0;
                  }),
                  "V-cavities with an index");
}
Reflectance form_of_lambert_grooves() {
  return required(find_form_if([](const ReflectanceInfo& f) { return by_slope_angle(f) && f.fittable(); }),
                  "Lambertian grooves");
}
Reflectance form_with_interreflection() {
  return required(find_form_if([](const ReflectanceInfo& f) { return by_slope_angle(f) && !f.fittable(); }),
                  "interreflecting grooves");
}

Material model(const Reflectance& form, const std::vector<std::pair<Role, double>>& values) {
  Material material = make_material(form, {"fr"});
  Term& term = material.terms.front();
  for (const auto& [role, number] : values) {
    if (const int k = form.info().weight_index(role); k >= 0) term.weights[0][k] = number;
    if (const int k = form.info().shape_index(role); k >= 0) term.shape[0][k] = number;
  }
  return material;
}

double value(const Material& material, const Vec& wi, const Vec& wo) {
  double f = 0;
  eval(material, wi, wo, {&f, 1});
  return f;
}

double cell_mean(const Material& material, const Incidence& from, const Cell& cell) {
  constexpr int kPoints = 8;
  const double c = std::cos(from.phi.radians()), s = std::sin(from.phi.radians());
  const Vec wi = direction(from.theta, from.phi);
  double sum = 0;
  for (int j = 0; j < kPoints; ++j) {
    for (int i = 0; i < kPoints; ++i) {
      const Vec at = cell.point((i + 0.5) / kPoints, (j + 0.5) / kPoints);
      const Vec wo{c * at.x - s * at.y, s * at.x + c * at.y, at.z};
      sum += value(material, wi, wo);
    }
  }
  return sum / (kPoints * kPoints);
}

}  // namespace brdf::micro
