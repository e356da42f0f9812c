// The subject of a check: a reflectance over its whole parameter domain, or a material with its own
// parameters.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "brdf/direction_sampler.h"
#include "io/material/expression.h"
#include "validate/search/finding.h"

namespace brdf::validate {

// Facts about outside code (such as a user's shader) that a form of the catalogue would provide itself.
// Empty functions mean that a fact is unknown.
struct OutsideFacts {
  std::string words;      // the equivalent command line options: "--shader FILE"
  bool oriented = false;  // reads the tangent, though it does not have two widths
  // The value is not proved to be unchanged when light and viewer turn together.
  bool may_turn = true;
  // Half of the azimuths is not proved to represent all azimuths, so searches cover the full circle.
  bool all_round = true;
  // Returns the place in the source that causes a check's finding, for one pair of directions; empty if
  // unknown.
  std::function<std::string(std::string_view check, const Material& at, const Vec3<double>& wi,
                            const Vec3<double>& wo)>
      explain = {};
  // Returns the place in the source that causes a step between two adjacent pairs; empty if unknown.
  std::function<std::string(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo,
                            const Vec3<double>& other_wi, const Vec3<double>& other_wo)>
      explain_jump = {};
  // Describes the undefined behaviour that the value depends on, in double or in float, with its source
  // line; empty if the value is defined.
  std::function<std::string(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo)> undefined =
      {};
  // Returns f of each channel in 1/sr, with more digits than double has, for the unit directions that these
  // represent.
  std::function<std::vector<double>(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo)>
      in_more_digits = {};
  // Returns f of each channel in 1/sr, in float with every value that has or may have 16 bits rounded to half
  // precision.
  std::function<std::vector<double>(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo)>
      in_half = {};
  // The reason why `in_half` is unknown although the code has values that may have 16 bits.
  std::string half_unknown = {};
  bool has_half_types = false;  // float itself rounds values to half precision
  // The sampler and the density that the code has for its reflectance; null if the code has neither.
  std::shared_ptr<const DirectionSampler> sampler = {};
  // Calls look() for each comparison that an evaluation of f makes. `number`: of the comparison; `line`: of
  // the source; `surplus`: above 0 where it holds, below 0 elsewhere, and 0 at the boundary.
  std::function<void(
      const Material& at, const Vec3<double>& wi, const Vec3<double>& wo,
      const std::function<void(std::uint32_t number, std::uint32_t line, bool holds, double surplus)>& look)>
      for_each_comparison = {};
  std::function<std::string(std::uint32_t line)> text_of_line = {};  // of the source
};

struct Jump;

// Parameters are searched on the unit cube. Diffuse and specular weights share the light, so their sum is
// at most 1. Other weights cover their tables' ranges up to 1. A shape parameter covers its table's range,
// logarithmically if the table declares a logarithmic scale.
class Subject {
 public:
  // A form, searched over its whole parameter domain.
  static Subject form(const Reflectance& form);
  // A material with its own parameters. `facts`: given if its form is not in the catalogue.
  static Subject material(std::string name, Material material, std::optional<OutsideFacts> facts = {});
  // A reflectance that is not in the catalogue. Its channels are the material's channels.
  static Subject outside(std::string name, const Material& material, OutsideFacts facts);

  const std::string& name() const { return name_; }
  const std::optional<Reflectance>& of_form() const { return form_; }
  // Returns the violations that the form declares; empty for a material.
  std::span<const Violation> declared() const;
  // Number of coordinates of the shape, then of the weights; both are 0 for a material.
  std::size_t shape_dimensions() const { return shape_dimensions_; }
  std::size_t dimensions() const { return shape_dimensions_ + weight_dimensions_; }
  // Returns whether the search includes the azimuth of the light.
  bool anisotropic() const { return anisotropic_; }
  // Returns the subject with searches that include every azimuth of the light, also if f is isotropic in real
  // numbers: rounding, underflow and overflow differ between the azimuths.
  Subject at_every_turn() const {
    Subject turned = *this;
    if (turned.outside_ && !anisotropic_) turned.outside_->all_round = true;
    turned.anisotropic_ = true;
    return turned;
  }

  // Returns the material at a point. A form without channels of its own has one channel, "fr".
  Material at(std::span<const double> point) const;
  // Returns the material itself, or the form with its default parameters.
  const Material& own() const { return material_; }
  std::vector<std::string> channels() const { return material_.channels; }

  // Returns the parameters of a material made by at(), by name; empty for a material.
  std::vector<std::pair<std::string, double>> parameters(const Material& at) const;
  // Returns the command `brdf VERB` for the material `at`, followed by `rest`; empty for a reflectance that
  // is neither in the catalogue nor outside code.
  std::string command(const std::string& verb, const Material& at, const std::string& rest) const;
  // Restricts the parameters. If the condition does not hold, the parameters that it names are moved
  // towards the minima of their tables until it holds. Throws InputError for a name that is not a
  // parameter, and if the condition does not hold when all parameters are at their minima.
  void restrict_to(const io::Condition& condition);
  bool is_restricted() const { return condition_.has_value(); }
  // Applies the same restriction to parameters that are chosen elsewhere.
  Material restricted(Material at) const;
  bool is_outside() const { return outside_.has_value(); }
  const OutsideFacts* outside_facts() const { return outside_ ? &*outside_ : nullptr; }
  // Lets the checks of samplers judge this sampler, which is the catalogue's own. Valid only for a form.
  void judge_also(std::shared_ptr<const DirectionSampler> sampler) { own_sampler_ = std::move(sampler); }
  // The sampler to judge, of the outside code or of the catalogue; null if no sampler is judged.
  const DirectionSampler* sampler() const;
  // Returns "; " followed by the explanation from the code's source; empty if there is no explanation.
  std::string explained(std::string_view check, const Material& at, const Vec3<double>& wi,
                        const Vec3<double>& wo) const;
  // Returns "; " followed by the source of the jump; empty if the source is unknown.
  std::string explained_jump(const Jump& jump) const;
  // Positions in the table of the weights that share the light.
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
  std::shared_ptr<const DirectionSampler> own_sampler_;
  std::optional<io::Condition> condition_;
};

// Returns the common name of both axes of an anisotropic form: the common part of their names, or else the
// name of the axis along the tangent.
std::string tied_name(const ReflectanceInfo& form);

// Returns the table's entry of a weight with the range that checks search: at most 1 of either sign.
ParameterInfo within_unit(ParameterInfo weight);

// Returns the value of a parameter at x in [0, 1] of its range from info.min to `max`.
double parameter_value(const ParameterInfo& info, double x, double max);

}  // namespace brdf::validate
