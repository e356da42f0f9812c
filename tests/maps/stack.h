// Synthetic stacks for the tests of maps, and the accuracy that such a stack permits.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "brdf/frame.h"
#include "brdf/material.h"
#include "io/files/temporary.h"
#include "io/material/settings.h"
#include "maps/stack_fit.h"
#include "synth/texels.h"
#include "texel/stack.h"

namespace brdf {

inline Material lacquer() {
  return io::choose_material(
      {"cook_torrance", "", {"kd=0.35,0.25,0.15", "ks=0.8", "f0=0.06,0.05,0.04", "alpha=0.2"}});
}

inline synth::TexelOptions small_stack(std::size_t size, int lights) {
  synth::TexelOptions o;
  o.width = o.height = size;
  o.lights = lights;
  o.vary = {{"alpha", 0.08, 0.5}, {"kd", 0.1, 0.6}};
  o.tilt = 30;
  return o;
}

inline maps::Settings settings_of(const Material& material, bool fits_normal) {
  maps::Settings s;
  for (const Term& term : material.terms) s.forms.push_back(term.form);
  s.fits_normal = fits_normal;
  return s;
}

// The free parameters of a texel under the names of their planes, and their standard errors if every pixel
// has relative noise `noise`. The errors come from the Jacobian at the truth (the bound of Cramer and Rao).
// They are practically infinite along directions without information.
struct Knowledge {
  std::vector<std::string> names;
  std::vector<double> values, errors;
};

// Returns the names, true values and standard errors of the free parameters; alpha counts once.
inline Knowledge known_of(const Material& material, const Vec3<double>& normal, bool fits_normal,
                          const io::SampleTable& lights, double noise) {
  Knowledge out;
  std::vector<double*> place;
  Material m = material;
  double n[2] = {normal.x, normal.y};
  out.names = {"alpha_x"};
  place = {nullptr};
  for (std::size_t c = 0; c < m.channels.size(); ++c)
    for (std::size_t k = 0; k < m.terms[0].weights[c].size(); ++k) {
      out.names.push_back(
          texel::plane_name(std::string(info(m.terms[0].form).weights[k].name), m.channels[c]));
      place.push_back(&m.terms[0].weights[c][k]);
    }
  for (int a = 0; a < 2 && fits_normal; ++a) {
    out.names.push_back(a == 0 ? "normal.x" : "normal.y");
    place.push_back(&n[a]);
  }
  const auto value = [&](std::size_t q) { return place[q] ? *place[q] : m.terms[0].shape[0][0]; };
  const auto set = [&](std::size_t q, double x) {
    if (place[q])
      *place[q] = x;
    else
      for (double& width : m.terms[0].shape[0]) width = x;
  };
  const DirectionArrays<double> arrays = io::unit_directions(lights);
  const auto pixels = [&](Eigen::VectorXd& v) {
    const Vec3<double> here{n[0], n[1], std::sqrt(1 - n[0] * n[0] - n[1] * n[1])};
    std::vector<double> pixel(m.channels.size());
    Eigen::Index row = 0;
    for (std::size_t k = 0; k < arrays.size(); ++k) {
      eval_cos(m, in_frame_of(here, arrays.view().wi(k)), in_frame_of(here, arrays.view().wo(k)), pixel);
      for (const double p : pixel) v(row++) = p;
    }
  };
  const Eigen::Index rows = Eigen::Index(arrays.size() * m.channels.size()),
                     size = Eigen::Index(place.size());
  Eigen::VectorXd v(rows), up(rows), down(rows);
  Eigen::MatrixXd j(rows, size);
  pixels(v);
  for (std::size_t q = 0; q < place.size(); ++q) {
    const double x = value(q), step = 1e-6 * std::max(std::abs(x), 0.1);
    out.values.push_back(x);
    set(q, x + step);
    pixels(up);
    set(q, x - step);
    pixels(down);
    set(q, x);
    for (Eigen::Index r = 0; r < rows; ++r)
      j(r, Eigen::Index(q)) = v(r) > 0 ? (up(r) - down(r)) / (2 * step) / (noise * v(r)) : 0;
  }
  const Eigen::VectorXd scale = j.colwise().norm().cwiseMax(1e-300);
  const Eigen::MatrixXd scaled = j * scale.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled.transpose() * scaled);
  for (Eigen::Index q = 0; q < size; ++q) {
    double variance = 0;
    for (Eigen::Index k = 0; k < size; ++k)
      variance += std::pow(eigen.eigenvectors()(q, k), 2) / std::max(eigen.eigenvalues()(k), 1e-15);
    out.errors.push_back(std::sqrt(variance) / scale(q));
  }
  return out;
}

}  // namespace brdf
