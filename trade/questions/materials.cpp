#include "trade/questions/materials.h"

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "trade/questions/names.h"

namespace brdf::trade {
namespace {

bool plays(const ParameterInfo& parameter, Role role) {
  return parameter.role == role || (role == Role::width && parameter.role == Role::width_across) ||
         (role == Role::exponent && parameter.role == Role::exponent_across);
}

void set_values(std::vector<std::vector<double>>& sets, std::span<const ParameterInfo> table, Role role,
                double value) {
  for (std::vector<double>& values : sets)
    for (std::size_t k = 0; k < table.size(); ++k)
      if (plays(table[k], role)) values[k] = value;
}

}  // namespace

Reflectance named_form(std::string_view name) {
  if (const auto form = find_form(name)) return *form;
  throw InputError("the catalogue has no form '" + std::string(name) +
                   "', which the questions of the ledger need");
}

Reflectance reference_form() {
  return named_form(names::kReferenceForm);
}

void set_parameter(Material& material, Role role, double value) {
  for (Term& term : material.terms) {
    set_values(term.weights, info(term.form).weights, role, value);
    set_values(term.shape, info(term.form).shape, role, value);
  }
}

std::string described(const Material& material) {
  const Term& term = material.terms.front();
  const ReflectanceInfo& about = info(term.form);
  std::string text(about.name);
  const auto add = [&](std::string_view name, double value) {
    text += ", " + std::string(name) + " " + io::short_number(value);
  };
  const auto [along, across] = about.axes();
  for (int k = 0; k < int(about.shape.size()); ++k)
    if (k != across)
      add(k == along ? about.tied_name() : about.shape[std::size_t(k)].name, term.shape[0][std::size_t(k)]);
  for (std::size_t k = 0; k < about.weights.size(); ++k) add(about.weights[k].name, term.weights[0][k]);
  return text;
}

}  // namespace brdf::trade
