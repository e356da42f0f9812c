// Quantities computed from a fitted material, with the uncertainty of the fit by the delta method on its
// parameters.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fit/assess/result.h"
#include "io/files/json.h"

namespace brdf::fit {

// A function that computes values from a material; the number of values is always the same.
using Derived = std::function<std::vector<double>(const Material&)>;

// The value of a parameter of a material, with the range of the parameter.
struct ParameterValue {
  double value, min, max;
};
// Returns the value of a parameter under its name in a ParameterCovariance; std::nullopt if the material does
// not have the parameter.
std::optional<ParameterValue> parameter_value(const Material& material, const std::string& name);

// The standard error of a derived value, with the degrees of freedom of its variance.
struct StandardError {
  double value, freedom;
};
// Returns the standard errors of the `count` values f(material) from the covariance alone, of first order in
// the parameters. Returns std::nullopt under the conditions of intervals().
std::optional<std::vector<StandardError>> standard_errors(const Material& material,
                                                          const ParameterCovariance& covariance,
                                                          std::size_t count, const Derived& f);

// Returns 95 % intervals of f(material) = values from the covariance alone. The standard error is of first
// order in the parameters (finite differences, central within the ranges of the parameters). The degrees of
// freedom are those of all components together. The variances of the components come from the same
// residuals, so their errors are assumed to be fully correlated. Returns std::nullopt if a name is not a
// parameter of the material.
std::optional<std::vector<Extent>> intervals(const Material& material, const ParameterCovariance& covariance,
                                             std::span<const double> values, const Derived& f);

// The name of the part of a covariance that is independent from row to row: the scatter of the rows, or the
// sources of a budget that every row has for itself, whichever is larger.
inline constexpr const char* kRowwiseSource = "independent from row to row";

// Returns the standard uncertainties of f(material) = values from the covariance alone, to first order, with
// the part of each source. Returns std::nullopt under the conditions of intervals().
std::optional<std::vector<Combined>> combined(const Material& material, const ParameterCovariance& covariance,
                                              std::span<const double> values, const Derived& f);

// The precision of the parameters of a fitted material.
struct Knowledge {
  std::optional<ParameterCovariance> covariance;
  std::vector<MaterialAtEnd> ends;  // of the parameters' intervals; empty: intervals of the curvature

  bool any() const { return covariance || !ends.empty(); }
  // Returns whether the budget of the instrument is in the covariance.
  bool has_budget() const { return covariance && !covariance->sources.empty(); }
};
// Returns the precision of the material of a fit.
Knowledge knowledge_of(const FormFit& fit);
// Reads the precision from the `fit` block of a material. The result is empty if the block holds no valid
// data.
Knowledge knowledge_of(const io::Json& fit);

// Returns 95 % intervals of f(material) = values. An interval is the union of two: the range of the values
// over the materials at the ends of the parameters' intervals, and the interval of the covariance, which
// covers directions between the parameters. An end is infinite if it comes from an open end of a parameter.
// Returns std::nullopt if nothing is known about the material.
std::optional<std::vector<Extent>> intervals(const Material& material, const Knowledge& known,
                                             std::span<const double> values, const Derived& f);

// Convert to and from the `fit` block of a material. covariance_of() returns std::nullopt if the block
// holds no valid covariance.
io::Json to_json(const ParameterCovariance& covariance);
std::optional<ParameterCovariance> covariance_of(const io::Json& fit);
io::Json to_json(std::span<const MaterialAtEnd> ends);

// Returns `[{"source", "standard_uncertainty", "share"}]`. The shares of the variance add up to 1.
io::Json parts_json(const Combined& combined);
// Returns a matrix as an array of its rows.
io::Json rows_json(const Matrix& matrix);

}  // namespace brdf::fit
