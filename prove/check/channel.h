// Materials at the parameters of one channel, for the search and for the check of certificates.
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
// The terms of a material.
using Channels = std::vector<Channel>;
// Returns the terms of a material, each at one channel's parameters.
Channels channels_of(const Material& material, std::size_t channel);

// Returns false for models of other programs.
bool is_of_catalogue(const Channel& c);

// Returns the domain of the claim with the channel's parameters in place of the ranges of their tables: the
// values in double and, for claims about float, the values rounded to float. Precondition:
// is_of_catalogue(c), and the claim is shown by boxes.
Domain domain_at(const Channel& c, const Claim& claim);

// Returns whether a sum of terms may overflow if their values add up to at most `high`.
bool may_overflow(double high, Precision precision);

// The largest directional albedo that the integrals of the library guarantee for this light (degrees).
// `least` is the value minus the error bound, or minus ten times that bound if the integral has not
// converged.
struct MeasuredAlbedo {
  double value = 0, least = 0;
};
// Integrates the terms for light from theta, phi (degrees).
MeasuredAlbedo measured_albedo(const Channels& terms, double theta, double phi);

// Returns a form with one channel at the parameters of a violation that the form declares.
Material declared_material(const Reflectance& form, const Violation& violation);

}  // namespace brdf::prove
