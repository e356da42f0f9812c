#include "interop/reading.h"
#include "interop/writers.h"

namespace brdf::interop {
namespace {

std::string colour(const Colour& c) {
  return "color(" + numbers(c) + ")";
}

// The closure of the lobe that the form stands for; "" where it has none.
std::string lobe_closure(const Reading& r) {
  if (r.has_shape(Role::exponent)) return "phong(N, " + number(r.shape(Role::exponent)) + ")";
  if (!r.has_shape(Role::width)) return "";
  r.check_widths(1e-4, 1e4, "nothing");
  const std::string widths = number(r.alpha_x()) + ", " + number(r.alpha_y());
  if (r.has_shape(Role::index))
    return "microfacet(\"ggx\", N, T, " + widths + ", " + number(r.shape(Role::index)) + ", 0)";
  return "ward(N, T, " + widths + ")";
}

std::string diffuse_closure(const Reading& r) {
  return r.has_shape(Role::slope) ? "oren_nayar(N, " + number(r.shape(Role::slope)) + ")" : "diffuse(N)";
}

std::string tangent(const Reading& r) {
  if (r.turn() == 0) return "    vector T = normalize(dPdu);\n";
  return "    vector T = normalize(vector(rotate(point(normalize(dPdu)), radians(" + number(r.turn()) +
         "), point(0), point(N))));\n";
}

}  // namespace

std::string write_osl(const Written& w) {
  const Reading r(w);
  const Colour kd = r.weight(Role::diffuse), ks = r.weight(Role::specular);
  const std::string lobe = is_black(ks) ? "" : lobe_closure(r);
  std::string text = comments(w.header, "// ") + "surface " + identifier(w.name) + "()\n{\n";
  if (lobe.find(", T, ") != lobe.npos) text += tangent(r);
  text += "    Ci = ";
  if (lobe.empty() || !is_black(kd)) text += colour(kd) + " * " + diffuse_closure(r);
  if (!lobe.empty()) text += (is_black(kd) ? "" : "\n       + ") + colour(ks) + " * " + lobe;
  return text + ";\n}\n";
}

}  // namespace brdf::interop
