// Samples of known materials and their fits.
#pragma once

#include <string>
#include <vector>

#include "fit/fit.h"
#include "synth/instrument.h"

namespace brdf::measured {

// A diffuse weight, a specular weight and a width.
struct Lobe {
  double diffuse, specular, width;
  double width_across = 0;  // 0: equal to `width`
};

// Returns a sum of microfacet terms with one channel.
inline Material lobes(const std::vector<Lobe>& of) {
  const Reflectance form = *find_form("cook_torrance");
  const ReflectanceInfo& info = form.info();
  Material m{{"f"}, {}};
  for (const Lobe& lobe : of) {
    Term term = make_term(form, 1);
    term.shape[0][std::size_t(info.axes().along)] = lobe.width;
    term.shape[0][std::size_t(info.axes().across)] = lobe.width_across > 0 ? lobe.width_across : lobe.width;
    const auto weight = [&](Role role) -> double& {
      return term.weights[0][std::size_t(info.weight_index(role))];
    };
    weight(Role::diffuse) = lobe.diffuse;
    weight(Role::specular) = lobe.specular;
    weight(Role::f0) = 0.5;
    m.terms.push_back(std::move(term));
  }
  return m;
}

// Returns samples over the hemisphere of viewers. `step` is the distance of the viewers in degrees; in
// azimuth the default is 10 degrees.
inline io::SampleTable scanned(const Material& truth, std::vector<double> theta_i, double noise,
                               std::vector<double> azimuths = {0}, double step = 5) {
  synth::Instrument instrument;
  instrument.grid.theta_i = std::move(theta_i);
  instrument.grid.azimuths = std::move(azimuths);
  instrument.grid.step = step;
  instrument.noise = noise;
  return synth::measure(truth, instrument);
}

inline Material fitted(const io::SampleTable& table, const std::vector<std::string>& forms,
                       const fit::FitOptions& options = {}) {
  std::vector<Reflectance> model;
  for (const std::string& form : forms) model.push_back(*find_form(form));
  return fit::fit(table, {model}, options).ranking.front().material;
}

}  // namespace brdf::measured
