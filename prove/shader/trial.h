// A shader's parameters and directions as a domain, and values tried in it.
#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "prove/proof.h"
#include "prove/shader/on_box.h"
#include "shader/shader.h"

namespace brdf::prove {

// The shader's parameters as variables, then its directions.
struct ShaderSubject {
  const shader::ShaderReflectance& model;
  const Material& material;
  std::string words;  // of the command line
  bool turns = true;  // the light has to be turned: no symmetry of the program is shown

  const shader::Function& function() const { return model.function(); }
  std::size_t parameters() const { return function().parameters.size(); }
  // Whole numbers where parameters are: the function computes with those, whatever it is given between them.
  std::vector<double> possible(std::vector<double> point) const;
  Domain domain(bool with_viewer) const;
  // A colour's three components are anywhere in its range, each.
  ShaderInputs inputs(std::span<const Bounds> box) const;
  // The material with these parameters, in the function's order; the words that say so are added.
  Material at(std::span<const double> values, std::string& said) const;
  std::vector<std::pair<std::string, double>> named(std::span<const double> values) const;
};

// A point of the domain: any, or a corner.
std::vector<double> point_of(const Domain& domain, std::mt19937_64& e);

// The same domain for cosines below the least one, where nothing is claimed.
Domain below(Domain domain);

// A direction in which f is defined and not as the claim's property says, finite or non-negative.
std::optional<Witness> fault_of(const ShaderSubject& s, const Claim& claim, const Domain& domain);

// A value that the language leaves undefined.
std::optional<std::string> undefined_of(const ShaderSubject& s, Precision precision, const Domain& domain);

}  // namespace brdf::prove
