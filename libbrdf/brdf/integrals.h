// Integrals of a form over the hemisphere, each with an error bound.
//
// The directional albedo integrates f_r cos over one direction with the other direction fixed. Rules:
//   pole      Gauss-Legendre in polar angle and azimuth about the mirror direction, mapped so that the
//             complex poles of a lobe of known width lie at a distance of order one; isotropic lobes only
//   slope     Gauss-Legendre in the slopes of the half vector: the lobe lies at the origin with its
//             widths along the axes, and the horizon is a circle; any lobe of the half vector
//   adaptive  bisection of cells in polar angle and azimuth; uses only the widths of a form
//   automatic pole for isotropic lobes, otherwise slope
// pole and slope increase their order until the error estimate
// max(|I_n - I_prev|, |I_prev - I_prevprev| / 10) meets the tolerance. A result that did not converge is
// marked as such; its bound is then only an estimate.
#pragma once

#include <vector>

#include "brdf/material.h"
#include "brdf/names.h"

namespace brdf {

enum class Fixed { light, viewer };
enum class Rule { automatic, pole, slope, adaptive };

template <>
inline constexpr std::array<std::string_view, 4> kNames<Rule>{"automatic", "pole", "slope", "adaptive"};

struct AlbedoOptions {
  Fixed fixed = Fixed::light;
  double tolerance = 1e-6;  // relative; rounding permits no less than 1e-12
  Rule rule = Rule::automatic;
  long max_evaluations = 4'000'000;
  // If > 0, use exactly this number of points per panel and dimension, without error control. Reference
  // values for tests of the error estimate; pole and slope only.
  int order = 0;
};

struct AlbedoResult {
  double value = 0;
  double error_bound = 0;  // absolute
  long evaluations = 0;    // of the form; shared by channels that were integrated together
  bool converged = false;
  Rule rule = Rule::automatic;
};

// Computes the integral of f_r cos over one direction with the other at (theta, phi), 0 <= theta <= 90
// degrees. The cosine belongs to the direction of integration. At 90 degrees the result is the limit
// towards grazing, as far as kMinCosine permits. The pole rule follows Johnston and Elliott 2005 (sinh
// maps); see docs/validation.md.
AlbedoResult directional_albedo(const Term& term, std::size_t channel, Angle theta, Angle phi,
                                const AlbedoOptions& options = {});

// Computes the albedo of all channels of a sum of terms. Channels that share a shape are integrated together.
// Example:
//     const brdf::Material material = make_material(*brdf::find_form("oren_nayar"));
//     for (const auto& albedo : directional_albedo(material, brdf::degrees(60), brdf::degrees(0)))
//       std::printf("%.6f, error at most %.1e\n", albedo.value, albedo.error_bound);
std::vector<AlbedoResult> directional_albedo(const Material& material, Angle theta, Angle phi,
                                             const AlbedoOptions& options = {});

// Integrates the lobes of a form that is linear in its weights: one integral per lobe, where f is the sum
// of weight times lobe. Returns an empty vector for other forms.
std::vector<AlbedoResult> lobe_albedos(const Reflectance& form, std::span<const double> shape, Angle theta,
                                       Angle phi, const AlbedoOptions& options = {});

// Computes the reflected fraction of uniform illumination, which is the mean of the directional albedo over
// projected solid angle.
AlbedoResult average_albedo(const Term& term, std::size_t channel, const AlbedoOptions& options = {});

}  // namespace brdf
