// A projected term as seen by writers: parameters by role, in red, green and blue.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interop/programs.h"
#include "io/files/identifier.h"

namespace brdf::interop {

using Colour = std::array<double, 3>;
using io::identifier;

// Access to the parameters of a written part.
class Reading {
 public:
  explicit Reading(const WrittenPart& part) : part_(part), form_(info(part.term.form)) {}

  // Returns the three colours. A single channel gives three equal values.
  Colour weight(Role role) const;
  Colour shape_colours(Role role) const;
  // Returns the colour of this role from the weights if the role is a weight, otherwise from the shape.
  Colour colour(Role role) const { return has_weight(role) ? weight(role) : shape_colours(role); }
  double shape(Role role) const { return shape_colours(role)[0]; }
  double shape(std::string_view name) const {
    return part_.term.shape[0][std::size_t(form_.shape_index(name))];
  }
  bool has_shape(Role role) const { return form_.shape_index(role) >= 0; }
  bool has_weight(Role role) const { return form_.weight_index(role) >= 0; }
  double metallic() const;
  double alpha_x() const { return shape(Role::width); }
  // Returns the other width, or the only one.
  double alpha_y() const { return has_shape(Role::width_across) ? shape(Role::width_across) : alpha_x(); }
  bool anisotropic() const { return alpha_x() != alpha_y(); }
  // Returns the square root of the widths' geometric mean.
  double roughness() const;
  double turn() const { return anisotropic() ? part_.tangent.degrees() : 0; }
  // Returns the azimuth of the material's alpha_x axis.
  double given_turn() const { return anisotropic() ? part_.given.degrees() : 0; }
  // Returns whether the wider axis lies along or across the mesh's tangent. If a format sets both widths
  // freely, they are written unchanged in both cases.
  bool along_tangent() const;
  bool crosswise() const;
  // Throws for programs that use the mesh's tangent. The message states the condition on the mesh and the
  // way to export then.
  [[noreturn]] void refuse_turn() const;
  std::pair<double, double> along_and_across() const {
    return crosswise() ? std::pair{alpha_y(), alpha_x()} : std::pair{alpha_x(), alpha_y()};
  }

  // Throws if the wider axis is across the tangent, for programs that widen along it.
  void check_wider_along(const std::string& program) const;
  // Returns glTF's anisotropyStrength: alpha_x = alpha_y + (1 - alpha_y) strength^2.
  double anisotropy_strength() const;

  // Throws if the program would treat the widths as a mirror, or if its control does not reach their ratio.
  void check_widths(double least, double most_ratio, const std::string& control) const;

 private:
  const WrittenPart& part_;
  const ReflectanceInfo& form_;
};

// The parts as shares of one surface, for programs that mix: a diffuse colour for the share that the lobes
// leave, and each lobe with its share and colour.
struct Shares {
  struct Lobe {
    std::size_t part;
    double share;
    Colour tint;  // each component at most 1
  };
  Colour diffuse{};  // colour of the diffuse share
  // The share that the lobes leave.
  double diffuse_share = 0;
  std::vector<Lobe> lobes{};
};
// Throws InputError if the weights add up to more than 1; `mix` names the program's node.
Shares shares_of(const Written& w, const std::string& mix);

// Return true if all three components are 0, or if all three are equal.
bool is_black(const Colour& c);
bool is_grey(const Colour& c);
// Returns x with nine significant digits, which preserve a float.
std::string number(double x);
// Returns "a, b, c".
std::string numbers(const Colour& c, const char* separator = ", ");
// Returns the header's lines as comments.
std::string comments(const std::vector<std::string>& header, const std::string& prefix);
// Returns the header as an XML processing instruction. XML comments cannot hold two adjacent hyphens, and
// commands from them could not be pasted.
std::string xml_header(const std::vector<std::string>& header);

}  // namespace brdf::interop
