#include "prove/check/channel.h"

#include <algorithm>
#include <limits>

#include "brdf/integrals.h"
#include "io/files/text.h"
#include "io/material/settings.h"

namespace brdf::prove {
namespace {

// Returns a value in double and, for claims about float, the value rounded to float.
Bounds as_stored(double x, Precision precision) {
  const double rounded = precision == Precision::float_type ? double(float(x)) : x;
  return {std::min(x, rounded), std::max(x, rounded)};
}

// Returns whether the form mixes channels. In that case the weights of the first channel are additional
// variables.
bool takes_first(const Channel& c) {
  return domain_of(catalogue_index(c.term.form)).variables.size() ==
         c.shape().size() + 2 * c.weights().size() + 4;
}

}  // namespace

Channels channels_of(const Material& material, std::size_t channel) {
  Channels terms;
  for (const Term& term : material.terms) terms.push_back({term, channel});
  return terms;
}

bool is_of_catalogue(const Channel& c) {
  return catalogue_index(c.term.form) >= 0;
}

Domain domain_at(const Channel& c, const Claim& claim) {
  Domain domain = *domain_of(claim);
  std::vector<double> values(c.shape().begin(), c.shape().end());
  values.insert(values.end(), c.weights().begin(), c.weights().end());
  if (takes_first(c)) values.insert(values.end(), c.term.weights[0].begin(), c.term.weights[0].end());
  for (std::size_t k = 0; k < std::min(values.size(), domain.variables.size()); ++k) {
    const Bounds at = as_stored(values[k], claim.precision);
    domain.variables[k].low = at.lo;
    domain.variables[k].high = at.hi;
  }
  return domain;
}

bool may_overflow(double high, Precision precision) {
  const double largest = precision == Precision::float_type ? double(std::numeric_limits<float>::max())
                                                            : std::numeric_limits<double>::max();
  return !(high <= 0.5 * largest);
}

MeasuredAlbedo measured_albedo(const Channels& terms, double theta, double phi) {
  MeasuredAlbedo sum;
  for (const Channel& c : terms) {
    const AlbedoResult found = directional_albedo(c.term, c.index, degrees(theta), degrees(phi));
    sum.value += found.value;
    sum.least += found.value - (found.converged ? 1 : 10) * found.error_bound;
  }
  return sum;
}

Material declared_material(const Reflectance& form, const Violation& violation) {
  std::vector<std::string_view> fields;
  io::split_blanks(violation.witness, fields);
  Material material = make_material(form, {"fr"});
  io::apply_settings(material, io::parse_settings({fields.begin(), fields.end()}, "witness"));
  return material;
}

}  // namespace brdf::prove
