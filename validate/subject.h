// What is judged: a form over its whole parameter domain, or a material with its own parameters.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "brdf/material.h"
#include "validate/finding.h"

namespace brdf::validate {

// Parameters are searched on the unit cube. Weights obey kd + ks <= 1 and
// stay at most 1, f0 and the listings' parameters cover their tables; a
// shape's range is its table's, logarithmic where the table says so.
class Subject {
 public:
  static Subject form(const Reflectance& form);
  static Subject material(std::string name, Material material);

  const std::string& name() const { return name_; }
  const std::optional<Reflectance>& of_form() const { return form_; }
  std::span<const Violation> declared() const;
  // Coordinates of the shape, then of the weights; both 0 for a material.
  std::size_t shape_dimensions() const { return shape_dimensions_; }
  std::size_t dimensions() const { return shape_dimensions_ + weight_dimensions_; }
  bool anisotropic() const { return anisotropic_; }

  // The material at a point (of one channel for a form).
  Material at(std::span<const double> point) const;
  const Material& own() const { return material_; }
  std::vector<std::string> channels() const { return material_.channels; }

  // Parameters of a material made by at(), by name, and the words that select it on the command line.
  std::vector<std::pair<std::string, double>> parameters(const Material& at) const;
  std::string selector(const Material& at) const;

 private:
  std::string name_;
  std::optional<Reflectance> form_;
  Material material_;
  std::size_t shape_dimensions_ = 0, weight_dimensions_ = 0;
  bool anisotropic_ = false;
};

// One parameter at x in [0, 1] of its range, and back.
double parameter_value(const ParameterInfo& info, double x, double max);

}  // namespace brdf::validate
