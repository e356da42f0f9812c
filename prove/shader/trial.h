// The parameters and directions of a shader as a domain, and trial evaluations in that domain.
#pragma once

#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "prove/proof.h"
#include "prove/shader/on_box.h"
#include "shader/shader.h"

namespace brdf::prove {

// The parameters of a shader as variables, followed by its directions.
struct ShaderSubject {
  const shader::ShaderReflectance& model;
  const Material& material;
  std::string words;  // of the command line
  bool turns = true;  // the light has to be rotated: no symmetry of the program is shown

  const shader::Function& function() const { return model.function(); }
  // The number of variables that represent a parameter: three for a colour whose first component may affect
  // the other channels, otherwise one.
  std::size_t width(const shader::Parameter& p) const {
    return p.colour && model.reads_first_channel() ? 3 : 1;
  }
  // The number of variables before the parameter, or of all parameters.
  std::size_t place(std::size_t parameter) const;
  std::size_t parameters() const { return place(function().parameters.size()); }
  // Returns the point with integer parameters rounded to whole numbers, since the function itself uses
  // whole numbers for any value between them.
  std::vector<double> possible(std::vector<double> point) const;
  Domain domain(bool with_viewer) const;
  // Returns the values of all parameters, from those of the variables.
  template <class T>
  std::vector<T> values(std::span<const T> variables) const {
    std::vector<T> out(function().values);
    std::size_t at = 0;
    for (const shader::Parameter& p : function().parameters) {
      for (std::size_t c = 0; c < (p.colour ? 3u : 1u); ++c)
        out[p.first + c] = variables[at + (width(p) > 1 ? c : 0)];
      at += width(p);
    }
    return out;
  }
  // Returns the inputs for a box. Each component of a colour that one variable represents is anywhere in the
  // variable's range. Whole parameters are whole numbers, whatever the function binds them to.
  ShaderInputs inputs(std::span<const Bounds> box) const;
  // Returns the material with these parameters, in the function's order. Appends the corresponding words of
  // the command line to `said`.
  Material at(std::span<const double> values, std::string& said) const;
  std::vector<std::pair<std::string, double>> named(std::span<const double> values) const;
};

// Returns a point of the domain: any point, or a corner.
std::vector<double> point_of(const Domain& domain, std::mt19937_64& e);

// Returns the same domain for cosines below the least one, where nothing is claimed.
Domain below(Domain domain);

// Returns the point as a witness if f, in the claim's scalar, is defined there and violates the claim's
// property (finite or non-negative).
std::optional<Witness> fault_at(const ShaderSubject& s, const Claim& claim, std::vector<double> point);

// Returns such a witness, found by trials in the domain and at every turn of the light.
std::optional<Witness> fault_of(const ShaderSubject& s, const Claim& claim, const Domain& domain);

// Returns a description of a value that the language leaves undefined.
std::optional<std::string> undefined_of(const ShaderSubject& s, Precision precision, const Domain& domain);

}  // namespace brdf::prove
