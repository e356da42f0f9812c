// Samples for the tests: known materials at known directions.
#pragma once

#include <functional>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fit/fit.h"
#include "fit/model/model.h"
#include "io/files/error.h"
#include "synth/instrument.h"

namespace brdf::fit {

inline io::SampleTable measured(const Material& material, std::vector<std::string> grid = {"hemisphere"},
                                double noise = 0, std::uint64_t seed = 1, double step = 10) {
  synth::Instrument instrument;
  instrument.grid.parts = std::move(grid);
  instrument.grid.step = step;
  instrument.grid.theta_i = {10, 30, 45, 60, 70};
  instrument.noise = noise;
  instrument.seed = seed;
  return synth::measure(material, instrument);
}

// Returns eight incidences over a hemisphere of viewers, for the steps of --form auto.
inline io::SampleTable fine_hemisphere(const Material& material, double noise, std::uint64_t seed) {
  synth::Instrument instrument;
  instrument.grid.parts = {"hemisphere"};
  instrument.grid.step = 15;
  instrument.grid.theta_i = {5, 15, 25, 35, 45, 55, 65, 75};
  instrument.noise = noise;
  instrument.seed = seed;
  return synth::measure(material, instrument);
}

inline FitOptions without_cross_validation() {
  FitOptions options;
  options.cross_validation = false;
  return options;
}

// Returns the first estimate with this name, or null. If `channel` is given, the estimate must belong to
// that channel; "" is a parameter that all channels share.
inline const Estimate* find_estimate(const FormFit& f, std::string_view name,
                                     std::optional<std::string_view> channel = std::nullopt) {
  for (const Estimate& e : f.estimates)
    if (e.name == name && (!channel || e.channel == *channel)) return &e;
  return nullptr;
}
inline const Estimate& estimate(const FormFit& f, std::string_view name) {
  const Estimate* found = find_estimate(f, name);
  if (found == nullptr) throw std::runtime_error("no estimate of " + std::string(name));
  return *found;
}

inline std::vector<Reflectance> forms(std::initializer_list<const char*> names) {
  std::vector<Reflectance> out;
  for (const char* name : names) out.push_back(*find_form(name));
  return out;
}

// Returns the message with which a model of these forms and channels refuses the options, or an empty
// string if the model accepts them.
inline std::string refusal(std::initializer_list<const char*> names, const FitOptions& options,
                           std::vector<std::string> channels = {"r", "g", "b"}) {
  try {
    Model(forms(names), std::move(channels), options);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

inline FormFit fit_one(const io::SampleTable& table, std::initializer_list<const char*> names,
                       const FitOptions& options = {}) {
  return fit(table, {forms(names)}, options).ranking.front();
}

// Returns a material with parameters drawn from the usual ranges of their tables, with alpha at least 0.02,
// ks at least 0.05 and f0 from 0.02 to 0.9.
inline Material random_material(const Reflectance& form, std::mt19937_64& random, std::size_t channels = 1,
                                bool tied = true) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (double(random() >> 11) * 0x1p-53);
  };
  const ReflectanceInfo& f = info(form);
  Material m = make_material(
      form, channels == 3 ? std::vector<std::string>{"r", "g", "b"} : std::vector<std::string>{"f"});
  for (std::size_t k = 0; k < f.shape.size(); ++k) {
    const ParameterInfo& p = f.shape[k];
    double low = p.min, high = p.usual_max;
    if (p.name.starts_with("alpha")) low = 0.02;
    if (p.name == "exponent") low = 1;
    m.terms[0].shape[0][k] =
        p.log_scale ? std::exp(uniform(std::log(low), std::log(high))) : uniform(low, high);
  }
  if (tied && f.shape_index("alpha_y") >= 0)
    m.terms[0].shape[0][std::size_t(f.shape_index("alpha_y"))] =
        m.terms[0].shape[0][std::size_t(f.shape_index("alpha_x"))];
  for (auto& weights : m.terms[0].weights)
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const std::string_view name = f.weights[k].name;
      weights[k] = name == "f0" ? uniform(0.02, 0.9) : uniform(name == "kd" ? 0.02 : 0.05, 1);
      // The other functions of a basis together stay below the constant.
      if (f.basis) weights[k] = k == 0 ? uniform(0.5, 1) : uniform(-0.45, 0.45) / double(weights.size());
    }
  return m;
}

inline double largest_relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, std::abs(a[k] - b[k]) / std::abs(b[k]));
  return worst;
}

}  // namespace brdf::fit
