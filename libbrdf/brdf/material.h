// Materials: forms with their parameters, for any number of channels.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "brdf/forms.h"

namespace brdf {

// One form with its parameters, each set in the order of the form's table.
struct Term {
  AnyForm form;
  std::vector<std::vector<double>> shape;    // one set shared by all channels, or one per channel
  std::vector<std::vector<double>> weights;  // [channel][parameter]
  double tangent_phi = 0;                    // azimuth of the tangent in the surface's frame, radians

  std::span<const double> shape_of(std::size_t channel) const {
    return shape[shape.size() == 1 ? 0 : channel];
  }
  friend bool operator==(const Term&, const Term&);
};

// The sum of its terms. Every term has one set of weights per channel.
struct Material {
  std::vector<std::string> channels;
  std::vector<Term> terms;
  friend bool operator==(const Material&, const Material&) = default;
};

// The form at its table's defaults.
Term make_term(const AnyForm& form, std::size_t channels);
Material make_material(const AnyForm& form, std::vector<std::string> channels = {"r", "g", "b"});

// f_r per channel in 1/sr, without cosine (eval_cos: times cos_i). Unit directions in the surface's frame; 0
// below the horizon, finite everywhere. `out` has one value per channel.
void eval(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> out);
void eval_cos(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo,
              std::span<double> out);

// The typed parameters of a term, for code that has visited its form.
template <Form F>
typename F::template Shape<double> typed_shape(F, const Term& term, std::size_t channel) {
  return from_values<typename F::template Shape<double>>(term.shape_of(channel));
}
template <Form F>
typename F::template Weights<double> typed_weights(F, const Term& term, std::size_t channel) {
  return from_values<typename F::template Weights<double>>(std::span<const double>(term.weights[channel]));
}

// Unit direction of a polar angle and azimuth in radians.
Vec3<double> direction(double theta, double phi);

}  // namespace brdf
