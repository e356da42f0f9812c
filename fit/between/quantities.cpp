#include "fit/between/quantities.h"

#include <algorithm>
#include <cmath>

#include "brdf/material.h"
#include "fit/assess/derived.h"
#include "fit/assess/reported.h"
#include "fit/report/plain_words.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

constexpr double kLightAzimuth = 180;  // degrees

bool has_logarithm(const FormFit& fit, const ComparedParameters& p, std::size_t k) {
  const auto value = parameter_value(fit.material, p.names[k]);
  return value && value->min >= 0 && p.natural[k] > kLeastForLogarithm * p.uncertainty(k);
}

ComparedParameters in_own_units(const FormFit& fit) {
  const ParameterCovariance& c = *fit.covariance;
  ComparedParameters out{c.names, std::vector<bool>(c.names.size()), {}, {}, c.components, c.freedom};
  for (const std::string& name : c.names)
    out.natural.push_back(parameter_value(fit.material, name).value_or(ParameterValue{kUnknown, 0, 0}).value);
  out.values = out.natural;
  return out;
}

void use_logarithm(ComparedParameters& p, std::size_t k) {
  p.logarithmic[k] = true;
  p.values[k] = std::log(p.natural[k]);
  for (std::size_t row = 0; row < p.components.rows; ++row) p.components(row, k) /= p.natural[k];
}

}  // namespace

AskedDirections asked_directions(const std::string& option, const std::string& text) {
  const auto refuse = [&](const std::string& rule) { throw InputError(option + " " + text + ": " + rule); };
  std::vector<double> angles;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    double angle = 0;
    if (!io::parse_number(text.substr(begin, end - begin), angle) || !std::isfinite(angle))
      refuse("must be THETA_I:THETA_O or THETA_I:THETA_O:PHI, numbers in degrees, as in 0:45");
    angles.push_back(angle);
    begin = end + 1;
  }
  if (angles.size() < 2 || angles.size() > 3)
    refuse("must be THETA_I:THETA_O or THETA_I:THETA_O:PHI, as in 0:45");
  for (const double theta : {angles[0], angles[1]})
    if (theta < 0 || theta >= 90) refuse("polar angles must be at least 0 and below 90 degrees");
  AskedDirections out{angles[0], angles[1]};
  if (angles.size() == 3) out.phi = angles[2];
  return out;
}

std::string to_text(const AskedDirections& at) {
  const std::string plain = io::to_text(at.theta_i) + ":" + io::to_text(at.theta_o);
  return at.phi == AskedDirections().phi ? plain : plain + ":" + io::to_text(at.phi);
}

std::vector<double> values_at(const Material& material, std::span<const AskedDirections> at) {
  std::vector<double> out, f(material.channels.size());
  for (const AskedDirections& d : at) {
    eval(material, direction(degrees(d.theta_i), degrees(kLightAzimuth)),
         direction(degrees(d.theta_o), degrees(kLightAzimuth + d.phi)), f);
    out.insert(out.end(), f.begin(), f.end());
  }
  return out;
}

std::size_t ComparedParameters::find(const std::string& name) const {
  return std::size_t(std::ranges::find(names, name) - names.begin());
}

double ComparedParameters::uncertainty(std::size_t parameter) const {
  double variance = 0;
  for (std::size_t k = 0; k < components.rows; ++k) variance += square(components(k, parameter));
  return std::sqrt(variance);
}

std::vector<ComparedParameters> compared_parameters(std::span<const FormFit* const> fits) {
  std::vector<ComparedParameters> all;
  for (const FormFit* fit : fits) all.push_back(in_own_units(*fit));
  std::vector<std::string> names;
  for (const ComparedParameters& p : all) names.insert(names.end(), p.names.begin(), p.names.end());
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  for (const std::string& name : names) {
    bool in_all = true;
    for (std::size_t t = 0; t < all.size(); ++t)
      if (const std::size_t k = all[t].find(name); k < all[t].names.size())
        in_all = in_all && has_logarithm(*fits[t], all[t], k);
    for (ComparedParameters& p : all)
      if (const std::size_t k = p.find(name); in_all && k < p.names.size()) use_logarithm(p, k);
  }
  return all;
}

std::string obstacle_of(const FormFit& fit, const std::string& parameter) {
  const bool has_covariance =
      fit.covariance && std::ranges::find(fit.covariance->names, parameter) != fit.covariance->names.end();
  for (const Estimate& e : fit.estimates) {
    if (label(e) != parameter && label(named(fit, e).symbol, e.channel) != parameter) continue;
    if (e.status == Status::at_bound) return parameter + " is at its bound";
    if (e.status == Status::unidentified) return parameter + " is not identifiable";
  }
  return has_covariance ? "" : "the uncertainty of " + parameter + " is not known";
}

}  // namespace brdf::fit
