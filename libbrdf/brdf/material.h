// Materials: reflectances with parameters, for any number of channels.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "brdf/reflectance.h"

namespace brdf {

// One reflectance with its parameters. Each set of parameters has the order of the form's table.
struct Term {
  Reflectance form;
  std::vector<std::vector<double>> shape;    // one set shared by all channels, or one per channel
  std::vector<std::vector<double>> weights;  // [channel][parameter]
  Angle tangent_phi{};                       // azimuth of the tangent in the frame of the surface

  std::span<const double> shape_of(std::size_t channel) const {
    return shape[shape.size() == 1 ? 0 : channel];
  }
  ParameterValues<double> values(std::size_t channel) const {
    return {weights[channel], weights[0], shape_of(channel), channel};
  }
  friend bool operator==(const Term&, const Term&) = default;
};

// A sum of terms. Every term has one set of weights per channel.
struct Material {
  std::vector<std::string> channels;
  std::vector<Term> terms;
  friend bool operator==(const Material&, const Material&) = default;
};

// Returns the form with the defaults of its table.
Term make_term(const Reflectance& form, std::size_t channels);
Material make_material(const Reflectance& form, std::vector<std::string> channels = {"r", "g", "b"});

// Returns true if the appearance depends on the azimuth of the sample, that is, if some term has two
// different widths.
bool is_anisotropic(const Material& material);

// Computes f_r per channel in 1/sr, without the cosine (eval_cos: times cos_i). Directions are unit vectors
// in the frame of the surface. The result is 0 below the horizon and always finite. `out` has one value per
// channel.
// Example:
//     const brdf::Material material = brdf::make_material(*brdf::find_form("cook_torrance"));
//     const auto wi = direction(brdf::degrees(45), brdf::degrees(0));
//     const auto wo = direction(brdf::degrees(40), brdf::degrees(180));
//     std::vector<double> f_r(material.channels.size());
//     eval(material, wi, wo, f_r);
void eval(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> out);
void eval_cos(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo,
              std::span<double> out);

// Evaluates one channel of a term at many directions in the frame of the surface. The function applies the
// term's tangent_phi.
void eval_batch(const Term& term, std::size_t channel, const Directions<double>& directions, double* out);
void eval_cos_batch(const Term& term, std::size_t channel, const Directions<double>& directions, double* out);
// Evaluates the same in float, with parameters rounded to float. Errors stay within the accuracy that the
// form declares for float.
void eval_batch(const Term& term, std::size_t channel, const Directions<float>& directions, float* out);
void eval_cos_batch(const Term& term, std::size_t channel, const Directions<float>& directions, float* out);

}  // namespace brdf
