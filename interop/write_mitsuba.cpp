#include <algorithm>

#include "interop/reading.h"
#include "interop/writers.h"
#include "io/error.h"

namespace brdf::interop {
namespace {

std::string value(const char* type, const char* name, const std::string& text) {
  return "    <" + std::string(type) + " name=\"" + name + "\" value=\"" + text + "\"/>\n";
}
std::string bsdf(const char* type, const std::string& attributes, const std::string& inside) {
  return "  <bsdf type=\"" + std::string(type) + "\" " + attributes + ">\n" + inside + "  </bsdf>\n";
}

// There is no control of the tangent besides the mesh.
void check_turn(const Reading& r, bool free_widths) {
  if (r.turn() == 0 || (free_widths && r.crosswise())) return;
  throw InputError("its tangent is the mesh's: turn the texture coordinates by " + number(r.turn()) +
                   " degrees instead and export with tangent_phi 0");
}

std::string conductor(const Reading& r, const std::string& attributes, const Colour& tint) {
  r.check_widths(1e-4, 1e4, "nothing");
  std::string inside = value("string", "distribution", "ggx");
  const auto [along, across] = r.along_and_across();
  if (r.anisotropic())
    inside += value("float", "alpha_u", number(along)) + value("float", "alpha_v", number(across));
  else
    inside += value("float", "alpha", number(r.alpha_x()));
  inside += value("float", "eta", number(r.shape(Role::index))) +
            value("float", "k", number(r.shape(Role::extinction))) +
            value("rgb", "specular_reflectance", numbers(tint));
  return bsdf("roughconductor", attributes, inside);
}

std::string diffuse_bsdf(const std::string& attributes, const Colour& colour) {
  return bsdf("diffuse", attributes, value("rgb", "reflectance", numbers(colour)));
}

Colour over(const Colour& c, double by) {
  return {std::min(c[0] / by, 1.0), std::min(c[1] / by, 1.0), std::min(c[2] / by, 1.0)};
}

// blendbsdf: weight w takes 1 - w of its first child and w of its second, in the order of their names.
std::string mixed(const Reading& r, const std::string& id) {
  const Colour kd = r.weight(Role::diffuse), ks = r.weight(Role::specular);
  if (is_black(ks)) return diffuse_bsdf(id, kd);
  if (!is_black(kd)) {
    const double share = std::max({ks[0], ks[1], ks[2]}), most = std::max({kd[0], kd[1], kd[2]});
    if (share + most > 1 + 1e-12)
      throw InputError("a blendbsdf of diffuse and roughconductor reaches weights of 1 together, not " +
                       number(share + most));
    return bsdf("blendbsdf", id,
                value("float", "weight", number(share)) +
                    diffuse_bsdf("name=\"a_diffuse\"", over(kd, 1 - share)) +
                    conductor(r, "name=\"b_lobe\"", over(ks, share)));
  }
  return conductor(r, id, ks);
}

std::string principled(const Reading& r, const std::string& id) {
  r.check_widths(1e-3, 10, "anisotropic");
  std::string inside = value("rgb", "base_color", numbers(r.weight(Role::diffuse))) +
                       value("float", "metallic", number(r.metallic())) +
                       value("float", "roughness", number(r.roughness())) +
                       value("float", "eta", number(std::max(r.shape(Role::index), 1.0 + 1e-6)));
  if (r.anisotropic()) inside += value("float", "anisotropic", number((1 - r.alpha_y() / r.alpha_x()) / 0.9));
  return bsdf("principled", id, inside);
}

}  // namespace

std::string write_mitsuba(const Written& w) {
  const Reading r(w);
  const std::string id = "id=\"" + identifier(w.name) + "\"";
  const bool sum = r.has_weight(Role::specular);
  check_turn(r, sum);
  return xml_comment(w.header) + "<scene version=\"3.0.0\">\n" + (sum ? mixed(r, id) : principled(r, id)) +
         "</scene>\n";
}

}  // namespace brdf::interop
