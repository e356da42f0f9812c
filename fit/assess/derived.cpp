#include "fit/assess/derived.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/assess/student.h"
#include "fit/model/constraints.h"
#include "io/material/material_json.h"

namespace brdf::fit {
namespace {

// Relative step of a parameter. The error of a central difference is its square.
constexpr double kDerivedStep = 1e-3;

// A value in a material, with the range of its parameter.
struct DerivedPlace {
  double* value;
  double min, max;
};

// Returns the places in the material that one parameter of the fit sets.
std::vector<DerivedPlace> places_of(Material& m, const std::string& name) {
  std::vector<DerivedPlace> out;
  for (std::size_t t = 0; t < m.terms.size(); ++t) {
    Term& term = m.terms[t];
    const ReflectanceInfo& about = info(term.form);
    const auto [along, across] = about.axes();
    const auto named = [&](std::string_view parameter, std::size_t channel) {
      const std::string plain = name_in_sum(m.terms.size(), t, parameter);
      return name == plain || name == plain + "[" + m.channels[channel] + "]";
    };
    const auto add = [&](double& value, const ParameterInfo& p) { out.push_back({&value, p.min, p.max}); };
    for (std::size_t g = 0; g < term.shape.size(); ++g)
      for (std::size_t k = 0; k < about.shape.size(); ++k)
        if (named(about.shape[k].name, g) ||
            ((int(k) == along || int(k) == across) && named(about.tied_name(), g)))
          add(term.shape[g][k], about.shape[k]);
    for (std::size_t c = 0; c < m.channels.size(); ++c)
      for (std::size_t k = 0; k < about.weights.size(); ++k)
        if (named(about.weights[k].name, c)) add(term.weights[c][k], about.weights[k]);
  }
  return out;
}

// Moves a parameter by a step, clipped to its range. tangent_phi, which turns every term, is in degrees.
// Returns the actual change, or std::nullopt if the material does not have the parameter.
std::optional<double> move(Material& m, const std::string& name, double step) {
  if (name == kTangentInfo.name) {
    for (Term& term : m.terms) term.tangent_phi = term.tangent_phi + degrees(step);
    return step;
  }
  const std::vector<DerivedPlace> places = places_of(m, name);
  if (places.empty()) return std::nullopt;
  const double before = *places[0].value,
               moved = std::clamp(before + step, places[0].min, places[0].max) - before;
  for (const DerivedPlace& place : places) *place.value += moved;
  return moved;
}

double standard_error(const ParameterCovariance& c, std::size_t parameter) {
  double variance = 0;
  for (std::size_t k = 0; k < c.components.rows; ++k) variance += square(c.components(k, parameter));
  return std::sqrt(variance);
}

double step_of(Material m, const std::string& name, double error) {
  if (name == kTangentInfo.name) return std::min(0.1 * error, 0.1);
  const std::vector<DerivedPlace> places = places_of(m, name);
  const double value = places.empty() ? 0 : std::abs(*places[0].value);
  return std::min(0.1 * error, kDerivedStep * std::max(value, kDerivedStep));
}

}  // namespace

std::optional<ParameterValue> parameter_value(const Material& material, const std::string& name) {
  if (name == kTangentInfo.name && !material.terms.empty())
    return ParameterValue{material.terms[0].tangent_phi.degrees(), kTangentInfo.min, kTangentInfo.max};
  Material m = material;
  const std::vector<DerivedPlace> places = places_of(m, name);
  if (places.empty()) return std::nullopt;
  return ParameterValue{*places[0].value, places[0].min, places[0].max};
}

namespace {

// Returns the derivatives of `count` values by the parameters, [parameter][value].
std::optional<std::vector<std::vector<double>>> slopes_of(const Material& material,
                                                          const ParameterCovariance& c, std::size_t count,
                                                          const Derived& f) {
  std::vector<std::vector<double>> slope;
  for (std::size_t k = 0; k < c.names.size(); ++k) {
    const double step = step_of(material, c.names[k], standard_error(c, k));
    Material up = material, down = material;
    if (!(step > 0)) return std::nullopt;
    const std::optional<double> upwards = move(up, c.names[k], step),
                                downwards = move(down, c.names[k], -step);
    if (!upwards || !downwards || !(*upwards > *downwards)) return std::nullopt;
    std::vector<double> above = f(up);
    const std::vector<double> below = f(down);
    for (std::size_t j = 0; j < count; ++j) above[j] = (above[j] - below[j]) / (*upwards - *downwards);
    slope.push_back(std::move(above));
  }
  return slope;
}

// Returns the change of a value along a component of the covariance.
double along(const ParameterCovariance& c, std::size_t component,
             const std::vector<std::vector<double>>& slope, std::size_t value) {
  double sum = 0;
  for (std::size_t a = 0; a < slope.size(); ++a) sum += slope[a][value] * c.components(component, a);
  return sum;
}

}  // namespace

std::optional<std::vector<StandardError>> standard_errors(const Material& material,
                                                          const ParameterCovariance& c, std::size_t count,
                                                          const Derived& f) {
  const auto slope = slopes_of(material, c, count, f);
  if (!slope) return std::nullopt;
  std::vector<StandardError> out;
  for (std::size_t j = 0; j < count; ++j) {
    double variance = 0, uncertain = 0;
    for (std::size_t k = 0; k < c.components.rows; ++k) {
      const double part = square(along(c, k, *slope, j));
      variance += part;
      uncertain += part / std::sqrt(c.freedom[k]);
    }
    out.push_back({std::sqrt(variance), variance > 0 ? square(variance / uncertain) : 0});
  }
  return out;
}

std::optional<std::vector<Extent>> intervals(const Material& material, const ParameterCovariance& c,
                                             std::span<const double> values, const Derived& f) {
  const auto errors = standard_errors(material, c, values.size(), f);
  if (!errors) return std::nullopt;
  std::vector<Extent> out;
  for (std::size_t j = 0; j < values.size(); ++j) {
    const StandardError& e = (*errors)[j];
    const double reach = e.value > 0 ? e.value * t_quantile(e.freedom) : 0;
    out.push_back({std::max(values[j] - reach, 0.0), values[j] + reach});
  }
  return out;
}

std::optional<std::vector<Combined>> combined(const Material& material, const ParameterCovariance& c,
                                              std::span<const double> values, const Derived& f) {
  const auto slope = slopes_of(material, c, values.size(), f);
  if (!slope) return std::nullopt;
  std::vector<Combined> out(values.size());
  for (std::size_t j = 0; j < values.size(); ++j) {
    double variance = 0;
    for (std::size_t k = 0; k < c.components.rows; ++k) {
      const std::string source = c.sources.empty() || c.sources[k].empty() ? kRowwiseSource : c.sources[k];
      auto part = std::ranges::find(out[j].parts, source, &Combined::Part::source);
      if (part == out[j].parts.end()) part = out[j].parts.insert(part, {source, 0});
      const double reach = along(c, k, *slope, j);
      part->standard_uncertainty = std::hypot(part->standard_uncertainty, reach);
      variance += reach * reach;
    }
    out[j].standard_uncertainty = std::sqrt(variance);
  }
  return out;
}

Knowledge knowledge_of(const FormFit& fit) {
  return {fit.covariance, fit.ends};
}

Knowledge knowledge_of(const io::Json& fit) {
  Knowledge out{covariance_of(fit), {}};
  if (!fit.is_object() || !fit.contains("ends")) return out;
  try {
    for (const io::Json& end : fit.at("ends"))
      out.ends.push_back({io::material_from_json(io::JsonPlace(end.at("material"), "fit")).material,
                          end.at("open").get<bool>()});
  } catch (const std::exception&) {
    out.ends.clear();  // a `fit` block may hold anything
  }
  return out;
}

std::optional<std::vector<Extent>> intervals(const Material& material, const Knowledge& known,
                                             std::span<const double> values, const Derived& f) {
  std::optional<std::vector<Extent>> out;
  if (known.covariance) out = intervals(material, *known.covariance, values, f);
  if (known.ends.empty()) return out;
  if (!out) {
    out.emplace();
    for (const double value : values) out->push_back({value, value});
  }
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  for (const MaterialAtEnd& end : known.ends) {
    const std::vector<double> there = f(end.material);
    for (std::size_t k = 0; k < values.size(); ++k) {
      Extent& e = (*out)[k];
      if (there[k] < e.low) e.low = end.open ? -kOpen : there[k];
      if (there[k] > e.high) e.high = end.open ? kOpen : there[k];
    }
  }
  return out;
}

io::Json to_json(std::span<const MaterialAtEnd> ends) {
  io::Json out = io::Json::array();
  for (const MaterialAtEnd& end : ends)
    out.push_back({{"open", end.open}, {"material", io::to_json(end.material)}});
  return out;
}

double Combined::share(const Part& part) const {
  return standard_uncertainty > 0 ? square(part.standard_uncertainty / standard_uncertainty) : 0;
}

io::Json parts_json(const Combined& combined) {
  io::Json parts = io::Json::array();
  for (const Combined::Part& part : combined.parts)
    parts.push_back({{"source", part.source},
                     {"standard_uncertainty", io::finite_or_null(part.standard_uncertainty)},
                     {"share", io::finite_or_null(combined.share(part))}});
  return parts;
}

io::Json rows_json(const Matrix& matrix) {
  io::Json rows = io::Json::array();
  for (std::size_t i = 0; i < matrix.rows; ++i) {
    io::Json row = io::Json::array();
    for (std::size_t j = 0; j < matrix.cols; ++j) row.push_back(matrix(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

io::Json to_json(const ParameterCovariance& c) {
  io::Json j{{"parameters", c.names}, {"components", rows_json(c.components)}, {"freedom", c.freedom}};
  if (!c.sources.empty()) j["sources"] = c.sources;
  return j;
}

std::optional<ParameterCovariance> covariance_of(const io::Json& fit) {
  if (!fit.is_object() || !fit.contains("covariance")) return std::nullopt;
  try {
    const io::Json& j = fit.at("covariance");
    ParameterCovariance out;
    out.names = j.at("parameters").get<std::vector<std::string>>();
    out.freedom = j.at("freedom").get<std::vector<double>>();
    const auto rows = j.at("components").get<std::vector<std::vector<double>>>();
    const std::size_t n = out.names.size();
    if (j.contains("sources")) out.sources = j.at("sources").get<std::vector<std::string>>();
    out.components = Matrix(rows.size(), n);
    if (out.freedom.size() != rows.size() || rows.size() != (out.sources.empty() ? n : out.sources.size()))
      return std::nullopt;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].size() != n || !(out.freedom[i] >= 1)) return std::nullopt;
      std::copy(rows[i].begin(), rows[i].end(), &out.components(i, 0));
    }
    return out;
  } catch (const io::Json::exception&) {
    return std::nullopt;  // a `fit` block may hold anything
  }
}

}  // namespace brdf::fit
