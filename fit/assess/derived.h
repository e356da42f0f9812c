// What is computed from a fitted material, with the fit's uncertainty: the delta method on its parameters.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fit/assess/result.h"
#include "io/files/json.h"

namespace brdf::fit {

// Values computed from a material, always as many.
using Derived = std::function<std::vector<double>(const Material&)>;

// 95 % intervals of f(material) = values by the covariance alone: the standard error is that of the first
// order in the parameters (differences, central within the parameters' ranges). Its degrees of freedom are
// those of the components together, whose variances, coming from the same residuals, are taken to err alike.
// None where a name is no parameter of the material's.
std::optional<std::vector<Extent>> intervals(const Material& material, const ParameterCovariance& covariance,
                                             std::span<const double> values, const Derived& f);

// How well a fit knows its material.
struct Knowledge {
  std::optional<ParameterCovariance> covariance;
  std::vector<MaterialAtEnd> ends;  // of the parameters' intervals; none: these are of the curvature

  bool any() const { return covariance || !ends.empty(); }
};
Knowledge knowledge_of(const FormFit& fit);
// As a material's `fit` block keeps it; empty where it keeps nothing that can be one.
Knowledge knowledge_of(const io::Json& fit);

// 95 % intervals of f(material) = values: the least and the largest value over the materials at the ends of
// the parameters' intervals, and the interval of the covariance, which knows directions between the
// parameters. An end is infinite where a parameter's open end decides it. Nothing is returned where nothing
// is known.
std::optional<std::vector<Extent>> intervals(const Material& material, const Knowledge& known,
                                             std::span<const double> values, const Derived& f);

// As a material's `fit` block keeps it. None where it holds no covariance, or one that cannot be one.
io::Json to_json(const ParameterCovariance& covariance);
std::optional<ParameterCovariance> covariance_of(const io::Json& fit);
io::Json to_json(std::span<const MaterialAtEnd> ends);

// A matrix as an array of its rows.
io::Json rows_json(const Matrix& matrix);

}  // namespace brdf::fit
