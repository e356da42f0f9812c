// Reasons why the normalised lobes of Phong and Blinn reflect no more than they receive, for every exponent
// and direction, each with the formula that it applies to (see majorants.h).
//
// Both rest on one inequality of rearrangement (Hardy, Littlewood and Polya 1934, chapter 10; on the sphere
// with its area). Take a function that falls with the angle from an axis. Among all functions that take the
// same values on equal areas, the one that falls with this angle too has the largest integral of the
// product. At normal incidence both albedos are 1.
#pragma once

#include "brdf/cosine_lobe.h"
#include "prove/scalar/lemmas.h"

namespace brdf::prove {

// k (r.o)^n on the hemisphere of the mirror direction r, k = (n+2)/(2 pi). The integral with cos_o over
// that whole hemisphere, lit or not, is the first moment, cos_i k 2 pi/(n+2) = cos_i. The lit part of cos_o
// is (cos_o + |cos_o|)/2. On that hemisphere |cos_o| takes the same values on equal areas as r.o, which
// falls with the angle from r. Therefore the integral with |cos_o| is at most 1, and the albedo of the lobe
// lies between cos_i and (1 + cos_i)/2.
struct PhongLobe {
  template <class S, class G>
  static S lobe(const S& n, const Geometry<G>& g) {
    return (n + S(2)) * S(1 / (2 * kPi)) * mirror_cosine_power(n, g);
  }
  // Returns 2 pi times the rounded constant 1/(2 pi).
  template <class I>
  static I normalisation() {
    return I::of(kPiBounds.lo, kPiBounds.hi) * I(2) * I(1 / (2 * kPi));
  }
  template <class I>
  static I albedo(const I& cosine) {
    return hull(cosine, I(0.5) * (I(1) + cosine));
  }
};

// k (n.h)^n is a mean of caps of half vectors, n.h > cos(tau). The directions with half vectors in such a
// cap have the solid angle that is the integral of 4 max(0, i.h) over the cap. This integral is at most
// that of 4 max(0, n.h), which is 4 pi sin(tau)^2, the solid angle of the cap of 2 tau about the normal.
// Among all sets of that solid angle, this cap (or the hemisphere) has the largest integral of the cosine,
// and at normal incidence the directions fill this cap. Therefore no direction has a larger albedo than
// normal incidence,
//   k 8 pi (n + 2^(-n/2))/((n+2)(n+4)) = 1.
struct BlinnLobe {
  static constexpr double kHalfLog2 = 0.34657359027997265;  // to 3e-17
  template <class S, class G>
  static S lobe(const S& n, const Geometry<G>& g) {
    return (n + S(2)) * (n + S(4)) / (S(8 * kPi) * (math::exp(n * S(-kHalfLog2)) + n)) *
           half_cosine_power(n, g);
  }
  // Returns 8 pi over the rounded constant 8 pi, times (n + 2^(-n/2))/(n + e^(-n c)). The last factor
  // differs from 1 by at most |c - ln(2)/2|.
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
