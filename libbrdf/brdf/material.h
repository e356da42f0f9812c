// Materials: reflectances with their parameters, for any number of channels.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "brdf/reflectance.h"

namespace brdf {

// One reflectance with its parameters, each set in the order of the form's table.
struct Term {
  Reflectance form;
  std::vector<std::vector<double>> shape;    // one set shared by all channels, or one per channel
  std::vector<std::vector<double>> weights;  // [channel][parameter]
  Angle tangent_phi{};                       // azimuth of the tangent in the surface's frame

  std::span<const double> shape_of(std::size_t channel) const {
    return shape[shape.size() == 1 ? 0 : channel];
  }
  ParameterValues<double> values(std::size_t channel) const {
    return {weights[channel], weights[0], shape_of(channel), channel};
  }
  friend bool operator==(const Term&, const Term&) = default;
};

// The sum of its terms. Every term has one set of weights per channel.
struct Material {
  std::vector<std::string> channels;
  std::vector<Term> terms;
  friend bool operator==(const Material&, const Material&) = default;
};

// The form at its table's defaults.
Term make_term(const Reflectance& form, std::size_t channels);
Material make_material(const Reflectance& form, std::vector<std::string> channels = {"r", "g", "b"});

// Whether it looks different from different azimuths: some term has two widths that differ.
bool is_anisotropic(const Material& material);

// f_r per channel in 1/sr, without cosine (eval_cos: times cos_i). Unit directions in the surface's frame; 0
// below the horizon, finite everywhere. `out` has one value per channel.
void eval(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> out);
void eval_cos(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo,
              std::span<double> out);

// One channel of a material's term at many directions in the surface's frame: its tangent_phi is applied.
void eval_batch(const Term& term, std::size_t channel, const Directions<double>& directions, double* out);
void eval_cos_batch(const Term& term, std::size_t channel, const Directions<double>& directions, double* out);
// The same in float, of parameters that are rounded to float: within the form's stated accuracy of float.
void eval_batch(const Term& term, std::size_t channel, const Directions<float>& directions, float* out);
void eval_cos_batch(const Term& term, std::size_t channel, const Directions<float>& directions, float* out);

}  // namespace brdf
