// What is judged: a reflectance over its whole parameter domain, or a material with its own parameters.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "brdf/material.h"
#include "io/material/expression.h"
#include "validate/search/finding.h"

namespace brdf::validate {

// Of code that is not ours: what no form's name says. Functions that are empty know nothing.
struct OutsideFacts {
  std::string words;      // of a command line that says the same: "--shader FILE"
  bool oriented = false;  // reads the tangent, though it has no two widths
  bool may_turn = true;   // nothing shows that the value stays when light and viewer turn together
  // Nothing shows that half of the azimuths stands for all: searches go all the way round.
  bool all_round = true;
  // Where in its source what a check found comes from, for one pair of directions; empty where that is not
  // known.
  std::function<std::string(std::string_view check, const Material& at, const Vec3<double>& wi,
                            const Vec3<double>& wo)>
      explain = {};
  // The same of a step between two pairs that lie beside one another.
  std::function<std::string(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo,
                            const Vec3<double>& other_wi, const Vec3<double>& other_wo)>
      explain_jump = {};
  // What the language leaves undefined of the value, in double or in float, with its line; empty: it is
  // defined.
  std::function<std::string(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo)> undefined =
      {};
  // f of each channel in more digits than double has, 1/sr, for the unit directions that these stand for.
  std::function<std::vector<double>(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo)>
      in_more_digits = {};
};

struct Jump;

// Parameters are searched on the unit cube. Diffuse and specular weights share
// the light: their sum is at most 1. The others cover their tables up to 1; a
// shape's range is its table's, logarithmic where the table says so.
class Subject {
 public:
  static Subject form(const Reflectance& form);
  // `facts`: where its form is no form of the catalogue.
  static Subject material(std::string name, Material material, std::optional<OutsideFacts> facts = {});
  // A reflectance that is not in the catalogue; its channels are those of the material.
  static Subject outside(std::string name, const Material& material, OutsideFacts facts);

  const std::string& name() const { return name_; }
  const std::optional<Reflectance>& of_form() const { return form_; }
  std::span<const Violation> declared() const;
  // Coordinates of the shape, then of the weights; both 0 for a material.
  std::size_t shape_dimensions() const { return shape_dimensions_; }
  std::size_t dimensions() const { return shape_dimensions_ + weight_dimensions_; }
  // Whether the azimuth of the light is searched, too.
  bool anisotropic() const { return anisotropic_; }

  // The material at a point (for a form of one channel, if it has none of its own).
  Material at(std::span<const double> point) const;
  const Material& own() const { return material_; }
  std::vector<std::string> channels() const { return material_.channels; }

  // Parameters of a material made by at(), by name.
  std::vector<std::pair<std::string, double>> parameters(const Material& at) const;
  // What a verb must be told to say the same of it; empty of a reflectance that is not in the catalogue.
  std::string command(const std::string& verb, const Material& at, const std::string& rest) const;
  // Restricts parameters: where the condition does not hold, those that it names go towards the least of
  // their tables until it does. Throws InputError for names that are no parameters, and where it does not
  // hold at the least of all.
  void restrict_to(const io::Condition& condition);
  bool is_restricted() const { return condition_.has_value(); }
  // The same for parameters that are chosen elsewhere.
  Material restricted(Material at) const;
  bool is_outside() const { return outside_.has_value(); }
  const OutsideFacts* outside_facts() const { return outside_ ? &*outside_ : nullptr; }
  // "; " and what the code's source says of it; empty where nothing is known.
  std::string explained(std::string_view check, const Material& at, const Vec3<double>& wi,
                        const Vec3<double>& wo) const;
  std::string explained_jump(const Jump& jump) const;
  // Which weights share the light: positions in the table.
  const std::vector<std::size_t>& shared_weights() const { return shared_; }

 private:
  std::string selector(const Material& at) const;

  std::string name_;
  std::optional<Reflectance> form_;
  Material material_;
  std::size_t shape_dimensions_ = 0, weight_dimensions_ = 0;
  std::vector<std::size_t> shared_;
  bool anisotropic_ = false;
  std::optional<OutsideFacts> outside_;
  std::optional<io::Condition> condition_;
};

// What both axes of an anisotropic form are called together: the common part of their names, or the one
// along.
std::string tied_name(const ReflectanceInfo& form);

// One parameter at x in [0, 1] of its range, and back.
double parameter_value(const ParameterInfo& info, double x, double max);

}  // namespace brdf::validate
