// Quantities of fitted tables that are compared between the tables: parameters, and values of f.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/assess/result.h"

namespace brdf::fit {

// The level of the tests for differences.
inline constexpr double kSignificance = 0.05;
// The least ratio of a value to its standard uncertainty for which the logarithm is compared.
inline constexpr double kLeastForLogarithm = 3;

// A pair of directions at which f is asked for, in degrees. The light is at the azimuth 180, as in most
// tables; phi is the azimuth from the light to the viewer, so that 180 is the side of the mirror direction.
struct AskedDirections {
  double theta_i = 0, theta_o = 45, phi = 180;
};
// Parses theta_i:theta_o or theta_i:theta_o:phi. Throws InputError, which names the option.
AskedDirections asked_directions(const std::string& option, const std::string& text);
// Returns "0:45", with the azimuth unless it is 180.
std::string to_text(const AskedDirections& at);
// Returns f of every channel at each of the directions, 1/sr: first all channels at the first directions.
std::vector<double> values_at(const Material& material, std::span<const AskedDirections> at);

// The parameters that a fit determines, with their covariance. A logarithmic parameter is compared as ln, so
// that its differences are relative.
struct ComparedParameters {
  std::vector<std::string> names;  // alpha, kd[r], terms[1].f0
  std::vector<bool> logarithmic;
  std::vector<double> natural;  // in their own units
  std::vector<double> values;   // on the scale of the comparison
  Matrix components;            // [component][parameter]: the covariance of `values` is the product A'A
  std::vector<double> freedom;  // [component]

  // Returns the number of a parameter, or names.size() if there is no such parameter.
  std::size_t find(const std::string& name) const;
  // Returns the standard uncertainty of a value.
  double uncertainty(std::size_t parameter) const;
};
// Returns the parameters of each fit, which has a covariance. A parameter is logarithmic if in every fit its
// range begins at 0 or above and its value is above three standard uncertainties.
std::vector<ComparedParameters> compared_parameters(std::span<const FormFit* const> fits);

// Returns the reason why the covariance does not describe a parameter of a fit, as a clause without the name
// of the table: "alpha is at its bound". Empty if there is no reason.
std::string obstacle_of(const FormFit& fit, const std::string& parameter);

}  // namespace brdf::fit
