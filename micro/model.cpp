#include "micro/model.h"

#include <stdexcept>
#include <string>

namespace brdf::micro {

Material model(std::string_view form, const std::vector<std::pair<std::string_view, double>>& parameters) {
  const auto found = find_form(form);
  if (!found) throw std::invalid_argument("no form " + std::string(form));
  Material material = make_material(*found, {"fr"});
  const ReflectanceInfo& table = info(*found);
  Term& term = material.terms.front();
  for (const auto& [name, number] : parameters) {
    if (const int k = table.weight_index(name); k >= 0) term.weights[0][k] = number;
    if (const int k = table.shape_index(name); k >= 0) term.shape[0][k] = number;
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
  const Vec wi = direction(radians(from.theta), radians(from.phi));
  double sum = 0;
  for (int j = 0; j < kPoints; ++j) {
    for (int i = 0; i < kPoints; ++i) {
      sum += value(material, wi, turned(cell.point((i + 0.5) / kPoints, (j + 0.5) / kPoints), from.phi));
    }
  }
  return sum / (kPoints * kPoints);
}

}  // namespace brdf::micro
