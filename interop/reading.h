// A projected term as writers read it: by roles, in red, green and blue.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "interop/programs.h"
#include "io/files/identifier.h"

namespace brdf::interop {

using Colour = std::array<double, 3>;
using io::identifier;

class Reading {
 public:
  explicit Reading(const WrittenPart& part) : part_(part), form_(info(part.term.form)) {}

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
  double turn() const { return anisotropic() ? part_.tangent.degrees() : 0; }
  // The azimuth that the material gives to the axis of its alpha_x.
  double given_turn() const { return anisotropic() ? part_.given.degrees() : 0; }
  // The wider axis lies along or across the mesh's tangent: where both widths are free they are written as
  // they are.
  bool along_tangent() const;
  bool crosswise() const;
  // Of programs whose tangent is the mesh's: what must be true of the mesh, and how to export then.
  [[noreturn]] void refuse_turn() const;
  std::pair<double, double> along_and_across() const {
    return crosswise() ? std::pair{alpha_y(), alpha_x()} : std::pair{alpha_x(), alpha_y()};
  }

  // Refuses widths that the program takes for a mirror, or whose ratio its control does not reach.
  void check_widths(double least, double most_ratio, const std::string& control) const;

 private:
  const WrittenPart& part_;
  const ReflectanceInfo& form_;
};

// The parts as shares of one surface, for programs that mix: a diffuse colour of what the lobes leave, and
// each lobe with its share and colour.
struct Shares {
  struct Lobe {
    std::size_t part;
    double share;
    Colour tint;  // at most 1
  };
  Colour diffuse{};  // of the diffuse share, which is what the lobes leave
  double diffuse_share = 0;
  std::vector<Lobe> lobes{};
};
// Throws InputError where the weights are above 1 together; `mix` names the program's node.
Shares shares_of(const Written& w, const std::string& mix);

bool is_black(const Colour& c);
bool is_grey(const Colour& c);
// Nine significant digits: a float as it stands.
std::string number(double x);
// "a, b, c".
std::string numbers(const Colour& c, const char* separator = ", ");
// The header's lines as comments.
std::string comments(const std::vector<std::string>& header, const std::string& prefix);
// The same in XML, as an instruction: in comments no two hyphens may meet, and commands could not be pasted.
std::string xml_header(const std::vector<std::string>& header);

}  // namespace brdf::interop
