#include "prove/scalar/claim.h"

#include <cmath>

#include "prove/scalar/energy.h"

namespace brdf::prove {

std::optional<Domain> domain_of(const Claim& claim) {
  switch (claim.property) {
    case Property::finite:
    case Property::non_negative:
      return domain_of(claim.form);
    case Property::energy:
      if (const EnergyMethod* method = energy_method(claim.form)) return method->domain;
      return std::nullopt;
    case Property::reciprocity:
      return std::nullopt;
  }
  return std::nullopt;
}

Bounds enclose(const Claim& claim, std::span<const Bounds> box) {
  if (claim.property == Property::energy) return energy_method(claim.form)->enclose(box);
  return enclose_value(claim.form, claim.precision, box);
}

bool settles(Property property, Bounds bounds, double most) {
  if (!std::isfinite(bounds.lo) || !std::isfinite(bounds.hi)) return false;
  return property == Property::non_negative ? bounds.lo >= 0
         : property == Property::energy     ? bounds.hi <= most
                                            : true;
}

}  // namespace brdf::prove
