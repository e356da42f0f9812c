// The Lambertian form.
#pragma once

#include "brdf/form.h"

namespace brdf {

// Lambert 1760: f = rho/pi.
// Domain: everywhere.
// Symmetry: isotropic, reciprocal. The albedo is rho at every angle.
// Known violations: only for rho > 1.
struct lambert : Takes<DiffuseWeights, NoShape> {
  static constexpr std::string_view name = "lambert";
  static constexpr std::string_view family = "lambert";
  static constexpr Accuracy accuracy{.in_float = {1.4e-7, 0, 0}, .in_double = {1.5e-16, 0, 0}};
  static constexpr Kink kink = Kink::none;
  static constexpr std::array albedos{ClosedAlbedo{0, 90, whole_albedo, "its definition"}};
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 1> lobes(const Shape<S>&, const Geometry<G>&) {
    return {S(1 / kPi)};
  }
};

}  // namespace brdf
