// Tables of known materials, and access to the findings of their sheets.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "brdf/forms.h"
#include "brdf/material.h"
#include "io/samples/samples.h"
#include "sheet/data_sheet.h"

namespace brdf::sheet {

// Directions of a goniometer. The light is at azimuth 180, the mirror direction at azimuth 0.
struct Grid {
  std::vector<double> lights{10, 20, 30, 40, 50, 60, 70};
  double step = 5, last = 80;                     // degrees, of the viewer's polar angle
  std::vector<double> azimuths = every(10, 180);  // of the viewer

  static std::vector<double> every(double step, double last) {
    std::vector<double> out;
    for (double phi = 0; phi <= last; phi += step) out.push_back(phi);
    return out;
  }
  static Grid in_plane(double step = 2) { return {.step = step, .azimuths = {0, 180}}; }
  static Grid half_plane(double step = 2) { return {.step = step, .azimuths = {0}}; }
};

inline Material glossy(double kd = 0.05, double ks = 0.9, double f0 = 0.06, double alpha = 0.15) {
  Term term = make_term(cook_torrance{}, 1);
  term.shape[0] = {alpha, alpha};
  term.weights[0] = {kd, ks, f0};
  return {{"fr"}, {term}};
}

inline Material matt(double rho) {
  Term term = make_term(lambert{}, 1);
  term.weights[0] = {rho};
  return {{"fr"}, {term}};
}

// Returns the material's values times exp(noise z), z normal.
inline io::SampleTable measured(const Material& material, const Grid& grid = {}, double noise = 0.01,
                                unsigned seed = 1) {
  io::SampleTable t;
  t.channels = material.channels;
  t.values.resize(t.channels.size());
  t.sigma.resize(t.channels.size());
  t.source = "table.csv";
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> f(t.channels.size());
  for (const double theta_i : grid.lights)
    for (double theta_o = 0; theta_o <= grid.last + 1e-9; theta_o += grid.step)
      for (const double phi : grid.azimuths) {
        if (theta_o == 0 && phi != grid.azimuths.front()) continue;
        eval(material, direction(degrees(theta_i), degrees(180)), direction(degrees(theta_o), degrees(phi)),
             f);
        t.add_directions(theta_i, 180, theta_o, phi);
        for (std::size_t c = 0; c < f.size(); ++c)
          t.values[c].push_back(f[c] * std::exp(noise * normal(random)));
        t.lines.push_back(std::uint32_t(t.lines.size() + 2));
      }
  return t;
}

// Returns the table with each value replaced by change(row, value).
inline io::SampleTable changed(io::SampleTable t,
                               const std::function<double(std::size_t row, double value)>& change) {
  for (auto& values : t.values)
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = change(k, values[k]);
  return t;
}

inline Finding finding(const DataSheet& sheet, std::string_view check) {
  const auto found = std::find_if(sheet.findings.begin(), sheet.findings.end(),
                                  [&](const Finding& f) { return f.check == check; });
  return found == sheet.findings.end() ? Finding{"", "no such check"} : *found;
}

inline Finding finding(const io::SampleTable& t, std::string_view check, const SheetOptions& options = {}) {
  return finding(data_sheet(t, options), check);
}

using Names = std::vector<std::string>;
inline Names failing(const io::SampleTable& t, const SheetOptions& options = {}) {
  Names names;
  for (const Finding& f : data_sheet(t, options).findings)
    if (f.outcome == Outcome::fail) names.push_back(f.check);
  return names;
}

}  // namespace brdf::sheet
