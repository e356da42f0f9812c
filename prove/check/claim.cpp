#include "prove/check/claim.h"

#include <algorithm>
#include <cmath>

#include "prove/energy/energy.h"
#include "prove/scalar/rounding.h"

namespace brdf::prove {

std::optional<Domain> domain_of(const Claim& claim) {
  switch (claim.property) {
    case Property::finite:
    case Property::non_negative:
      return value_domain_of(claim.form);
    case Property::energy:
      if (const EnergyMethod* method = energy_method(claim.form)) return method->domain;
      return std::nullopt;
    case Property::rounding:
      return rounding_domain(claim.form);
    case Property::reciprocity:
      return std::nullopt;
  }
  return std::nullopt;
}

namespace {

Bounds worst_lobe(const Claim& claim, std::span<const Bounds> box) {
  double worst = 0;
  for (const LobeRounding& lobe : rounding_of(claim.form, claim.precision, box))
    worst = std::max(worst, lobe.error);
  return {0, worst};
}

}  // namespace

Bounds enclose(const Claim& claim, std::span<const Bounds> box) {
  if (claim.property == Property::rounding) return worst_lobe(claim, box);
  if (claim.property == Property::energy) return energy_method(claim.form)->enclose(box);
  return enclose_value(claim.form, claim.precision, box);
}

std::string_view scalar_of(const Claim& claim) {
  return is_of_a_precision(claim.property) ? name_of(claim.precision) : "any";
}

std::string arithmetic_of(const Claim& claim, bool bit_for_bit) {
  const std::string rounded = "as rounded in " + std::string(name_of(claim.precision));
  switch (claim.property) {
    case Property::finite:
    case Property::non_negative:
      return rounded;
    case Property::rounding:
      return rounded + ", beside exact";
    case Property::energy:
      return "exact, of the constants as rounded";
    case Property::reciprocity:
      return bit_for_bit ? "every IEEE precision, bit for bit" : "exact";
  }
  return "";
}

std::string_view statement_of(Property property) {
  return property == Property::finite
             ? "no overflow, no division by 0 and no domain error in the evaluation of f"
             : "f is never below 0";
}

bool settles(Property property, Bounds bounds, double most) {
  if (!std::isfinite(bounds.lo) || !std::isfinite(bounds.hi)) return false;
  return property == Property::non_negative ? bounds.lo >= 0
         : property == Property::energy     ? bounds.hi <= most
                                            : true;
}

}  // namespace brdf::prove
