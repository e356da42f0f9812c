#include "prove/scalar/claim.h"

#include <algorithm>
#include <cmath>

#include "prove/scalar/energy.h"
#include "prove/scalar/rounding.h"

namespace brdf::prove {

std::optional<Domain> domain_of(const Claim& claim) {
  switch (claim.property) {
    case Property::finite:
    case Property::non_negative:
      return domain_of(claim.form);
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

bool settles(Property property, Bounds bounds, double most) {
  if (!std::isfinite(bounds.lo) || !std::isfinite(bounds.hi)) return false;
  return property == Property::non_negative ? bounds.lo >= 0
         : property == Property::energy     ? bounds.hi <= most
                                            : true;
}

}  // namespace brdf::prove
