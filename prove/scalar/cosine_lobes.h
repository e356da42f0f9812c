// Why the normalised lobes of Phong and Blinn reflect no more than they receive, for every exponent and
// direction: authored reasons, each with the formula that it is of (see majorants.h).
//
// Both rest on one inequality of rearrangement (Hardy, Littlewood and Polya 1934, chapter 10; on the sphere
// with its area): of all functions that take the same values on equal areas, none has a larger integral
// beside one that falls with the angle from an axis than the one that falls with it too. At normal incidence
// both albedos are 1.
#pragma once

#include "brdf/cosine_lobe.h"
#include "prove/scalar/lemmas.h"

namespace brdf::prove {

// k (r.o)^n on the hemisphere of the mirror direction r, k = (n+2)/(2 pi). Of cos_o, lit or not, it keeps its
// first moment, cos_i k 2 pi/(n+2) = cos_i. What is lit is (cos_o + |cos_o|)/2, and on that hemisphere
// |cos_o| takes the same values on equal areas as r.o, which falls with the angle from r: so |cos_o| keeps at
// most 1, and the lobe's albedo lies between cos_i and (1 + cos_i)/2.
struct PhongLobe {
  template <class S, class G>
  static S lobe(const S& n, const Geometry<G>& g) {
    return (n + S(2)) * S(1 / (2 * kPi)) * mirror_cosine_power(n, g);
  }
  // 2 pi times 1/(2 pi) as it is rounded.
  template <class I>
  static I normalisation() {
    return I::of(kPiBounds.lo, kPiBounds.hi) * I(2) * I(1 / (2 * kPi));
  }
  template <class I>
  static I albedo(const I& cosine) {
    return hull(cosine, I(0.5) * (I(1) + cosine));
  }
};

// k (n.h)^n, which is a mean of caps of half vectors, n.h > cos(tau). Directions whose half vectors lie in
// such a cap fill the integral of 4 max(0, i.h) over it; beside the cap, max(0, i.h) has at most what max(0,
// n.h) has: 4 pi sin(tau)^2, which is the solid angle of the cap of 2 tau about the normal. None of that
// solid angle has a larger integral of the cosine than that cap, or the hemisphere; and at normal incidence
// it is that cap. So no direction's albedo exceeds that of normal incidence,
//   k 8 pi (n + 2^(-n/2))/((n+2)(n+4)) = 1.
struct BlinnLobe {
  static constexpr double kHalfLog2 = 0.34657359027997265;  // to 3e-17
  template <class S, class G>
  static S lobe(const S& n, const Geometry<G>& g) {
    return (n + S(2)) * (n + S(4)) / (S(8 * kPi) * (math::exp(n * S(-kHalfLog2)) + n)) *
           half_cosine_power(n, g);
  }
  // 8 pi beside 8 pi as it is rounded, and (n + 2^(-n/2))/(n + e^(-n c)), which is off by at most |c -
  // ln(2)/2|.
  template <class I>
  static I normalisation() {
    return I::of(kPiBounds.lo, kPiBounds.hi) * I(8) / I(8 * kPi) * I::widened(1, 1);
  }
  template <class I>
  static I albedo(const I&) {
    return I::of(0, 1);
  }
};

}  // namespace brdf::prove
