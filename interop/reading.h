// A projected term as writers read it: by roles, in red, green and blue.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "interop/programs.h"
#include "io/identifier.h"

namespace brdf::interop {

using Colour = std::array<double, 3>;
using io::identifier;

class Reading {
 public:
  explicit Reading(const Written& w) : w_(w), form_(info(w.term.form)) {}

  // Of the three colours; of one channel all the same.
  Colour weight(Role role) const;
  Colour shape_colours(Role role) const;
  // Wherever it stands.
  Colour colour(Role role) const { return has_weight(role) ? weight(role) : shape_colours(role); }
  double shape(Role role) const { return shape_colours(role)[0]; }
  bool has_shape(Role role) const { return form_.shape_index(role) >= 0; }
  bool has_weight(Role role) const { return form_.weight_index(role) >= 0; }
  double metallic() const;
  double alpha_x() const { return shape(Role::width); }
  double alpha_y() const { return shape(Role::width_across); }
  bool anisotropic() const { return alpha_x() != alpha_y(); }
  // Square root of the widths' geometric mean.
  double roughness() const;
  double turn() const { return anisotropic() ? w_.tangent.degrees() : 0; }
  // The wider axis lies across the tangent: where both widths are free they are exchanged instead.
  bool crosswise() const;
  std::pair<double, double> along_and_across() const {
    return crosswise() ? std::pair{alpha_y(), alpha_x()} : std::pair{alpha_x(), alpha_y()};
  }

  // Refuses widths that the program takes for a mirror, or whose ratio its control does not reach.
  void check_widths(double least, double most_ratio, const std::string& control) const;

 private:
  const Written& w_;
  const ReflectanceInfo& form_;
};

bool is_black(const Colour& c);
bool is_grey(const Colour& c);
// Nine significant digits: a float as it stands.
std::string number(double x);
// "a, b, c".
std::string numbers(const Colour& c, const char* separator = ", ");
// The header's lines as comments.
std::string comments(const std::vector<std::string>& header, const std::string& prefix);
// The same in XML, where no two hyphens may meet.
std::string xml_comment(const std::vector<std::string>& header);

}  // namespace brdf::interop
