#include "interop/reading.h"
#include "io/files/numbers.h"

namespace brdf::interop {
namespace {

std::string colour(const Colour& c) {
  return "color(" + numbers(c) + ")";
}

// Returns the closure of the lobe that the form represents, or "" if the form has no lobe.
std::string lobe_closure(const Reading& r, const std::string& tangent) {
  if (r.has_shape(Role::exponent)) return "phong(N, " + number(r.shape(Role::exponent)) + ")";
  if (!r.has_shape(Role::width)) return "";
  r.check_widths(1e-4, 1e4, "nothing");
  const std::string widths = number(r.alpha_x()) + ", " + number(r.alpha_y());
  if (r.has_shape(Role::index))
    return "microfacet(\"ggx\", N, " + tangent + ", " + widths + ", " + number(r.shape(Role::index)) + ", 0)";
  return "ward(N, " + tangent + ", " + widths + ")";
}

std::string diffuse_closure(const Reading& r) {
  return r.has_shape(Role::slope) ? "oren_nayar(N, " + number(r.shape(Role::slope)) + ")" : "diffuse(N)";
}

std::string tangent(const Reading& r, const std::string& name) {
  if (r.turn() == 0) return "    vector " + name + " = normalize(dPdu);\n";
  return "    vector " + name + " = normalize(vector(rotate(point(normalize(dPdu)), radians(" +
         number(r.turn()) + "), point(0), point(N))));\n";
}

}  // namespace

std::string write_osl(const Written& w) {
  std::string tangents;
  std::vector<std::string> sum;
  for (std::size_t k = 0; k < w.parts.size(); ++k) {
    const Reading r(w.parts[k]);
    const Colour kd = r.weight(Role::diffuse), ks = r.weight(Role::specular);
    const std::string axis = w.parts.size() > 1 ? "T" + std::to_string(k + 1) : "T";
    const std::string lobe = is_black(ks) ? "" : lobe_closure(r, axis);
    if (lobe.find(", " + axis + ", ") != lobe.npos) tangents += tangent(r, axis);
    if (!is_black(kd) || (lobe.empty() && w.parts.size() == 1))
      sum.push_back(colour(kd) + " * " + diffuse_closure(r));
    if (!lobe.empty()) sum.push_back(colour(ks) + " * " + lobe);
  }
  return comments(w.header, "// ") + "surface " + io::identifier(w.name, io::NameIn::osl) + "()\n{\n" +
         tangents + "    Ci = " + io::joined(sum, "\n       + ") + ";\n}\n";
}

}  // namespace brdf::interop
