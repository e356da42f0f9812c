// Materials at one channel's parameters: what the search and the check of certificates share.
#pragma once

#include <span>
#include <vector>

#include "brdf/material.h"
#include "prove/check/claim.h"

namespace brdf::prove {

struct Channel {
  const Term& term;
  std::size_t index;

  std::span<const double> shape() const { return term.shape_of(index); }
  std::span<const double> weights() const { return term.weights[index]; }
};
// A material's terms.
using Channels = std::vector<Channel>;
Channels channels_of(const Material& material, std::size_t channel);

// False of other programs' models.
bool is_of_catalogue(const Channel& c);

// The claim's domain with the channel's parameters in place of their tables' ranges: as double has them and,
// for claims of float, as float rounds them. Precondition: is_of_catalogue(c), and the claim is shown by
// boxes.
Domain domain_at(const Channel& c, const Claim& claim);

// Whether a sum of terms whose values add up to at most `high` may overflow.
bool may_overflow(double high, Precision precision);

// The largest directional albedo that the integrals of the library are sure of at this light, degrees: below
// its value by the error bound, ten times that where the integral has not converged.
struct MeasuredAlbedo {
  double value = 0, least = 0;
};
MeasuredAlbedo measured_albedo(const Channels& terms, double theta, double phi);

// A form at the parameters of a violation that it declares, one channel.
Material declared_material(const Reflectance& form, const Violation& violation);

}  // namespace brdf::prove
