#include "prove/scalar/enclosed.h"

#include <cmath>

#include "brdf/forms.h"
#include "prove/scalar/matt_box.h"

namespace brdf::prove {
namespace {

template <class P>
void add_parameters(Domain& domain, const std::string& prefix, bool weight) {
  for (const auto& field : P::fields())
    domain.variables.push_back(
        {prefix + std::string(field.info.name), field.info.min, field.info.max,
         field.info.log_scale && field.info.min > 0 ? Variable::Cut::logarithmic : Variable::Cut::middle,
         weight});
}

}  // namespace

namespace {

// Returns the parameters of a form, without the directions.
Domain parameters_of(int place) {
  Domain domain;
  with_form(place, [&](auto form) {
    using F = decltype(form);
    add_parameters<typename F::template Shape<double>>(domain, "", false);
    add_parameters<typename F::template Weights<double>>(domain, "", true);
    if constexpr (!LinearForm<F>)
      add_parameters<typename F::template Weights<double>>(domain, "first.", true);
  });
  return domain;
}

}  // namespace

Domain domain_of(int place) {
  Domain domain = parameters_of(place);
  for (const char* w : {"i", "o"}) {
    domain.variables.push_back({std::string("cos_") + w, 0, 1, Variable::Cut::cosine});
    domain.variables.push_back({std::string("turn_") + w, -2, 2, Variable::Cut::middle});
  }
  return domain;
}

Domain value_domain_of(int place) {
  bool is_basis = false;
  with_form(place, [&](auto form) { is_basis = MattForm<decltype(form)>; });
  if (!is_basis) return domain_of(place);
  Domain domain = parameters_of(place);
  for (const char* name : {"r_i", "r_o"}) domain.variables.push_back({name, 0, 1, Variable::Cut::middle});
  domain.variables.push_back({"cos_dphi", -1, 1, Variable::Cut::middle});
  return domain;
}

double cut_of(const Variable& variable, Bounds range) {
  const double low =
      variable.cut == Variable::Cut::cosine ? std::fmax(range.lo, kMinCosine<double>) : range.lo;
  if (variable.cut != Variable::Cut::middle && low > 0 && range.hi > 2 * low)
    return std::sqrt(low) * std::sqrt(range.hi);
  return range.lo + 0.5 * (range.hi - range.lo);
}

}  // namespace brdf::prove
