#include <algorithm>
#include <functional>
#include <vector>

#include "interop/reading.h"
#include "io/files/error.h"

namespace brdf::interop {
namespace {

std::string element(const char* type, const char* name, const std::string& text) {
  return "    <" + std::string(type) + " name=\"" + name + "\" value=\"" + text + "\"/>\n";
}
std::string bsdf(const char* type, const std::string& attributes, const std::string& inside) {
  return "  <bsdf type=\"" + std::string(type) + "\" " + attributes + ">\n" + inside + "  </bsdf>\n";
}

std::string conductor(const Reading& r, const std::string& attributes, const Colour& tint) {
  r.check_widths(1e-4, 1e4, "nothing");
  std::string inside = element("string", "distribution", "ggx");
  const auto [along, across] = r.along_and_across();
  if (r.anisotropic())
    inside += element("float", "alpha_u", number(along)) + element("float", "alpha_v", number(across));
  else
    inside += element("float", "alpha", number(r.alpha_x()));
  const auto of_colours = [](const char* name, const Colour& c) {
    return is_grey(c) ? element("float", name, number(c[0])) : element("rgb", name, numbers(c));
  };
  inside += of_colours("eta", r.shape_colours(Role::index)) +
            of_colours("k", r.shape_colours(Role::extinction)) +
            element("rgb", "specular_reflectance", numbers(tint));
  return bsdf("roughconductor", attributes, inside);
}

std::string diffuse_bsdf(const std::string& attributes, const Colour& colour) {
  return bsdf("diffuse", attributes, element("rgb", "reflectance", numbers(colour)));
}

// Blends the parts. A blendbsdf of weight w takes 1 - w of its first child and w of its second, in the order
// of their names.
std::string mixed(const Written& w, const std::string& id) {
  const Shares shares = shares_of(w, "a blendbsdf of diffuse and roughconductor");
  if (shares.lobes.empty()) return diffuse_bsdf(id, shares.diffuse);
  if (shares.lobes.size() == 1 && is_black(shares.diffuse)) {
    const Reading r(w.parts[shares.lobes.front().part]);
    return conductor(r, id, r.weight(Role::specular));
  }
  // The blends are listed from the innermost outward. Each takes the share of its last child.
  struct Piece {
    double share;
    std::function<std::string(const std::string&)> text;
  };
  std::vector<Piece> pieces;
  if (shares.diffuse_share > 0)
    pieces.push_back({shares.diffuse_share, [&](const std::string& attributes) {
                        return diffuse_bsdf(attributes, shares.diffuse);
                      }});
  for (const Shares::Lobe& lobe : shares.lobes)
    pieces.push_back({lobe.share, [&](const std::string& attributes) {
                        return conductor(Reading(w.parts[lobe.part]), attributes, lobe.tint);
                      }});
  double sum = pieces.front().share;
  std::string text = pieces.front().text(pieces.size() == 1 ? id : "name=\"a_first\"");
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    sum += pieces[k].share;
    const bool outermost = k + 1 == pieces.size();
    text = bsdf("blendbsdf", outermost ? id : "name=\"a_first\"",
                element("float", "weight", number(pieces[k].share / sum)) + text +
                    pieces[k].text("name=\"b_second\""));
  }
  return text;
}

std::string principled(const Reading& r, const std::string& id) {
  r.check_widths(1e-3, 10, "anisotropic");
  std::string inside = element("rgb", "base_color", numbers(r.weight(Role::diffuse))) +
                       element("float", "metallic", number(r.metallic())) +
                       element("float", "roughness", number(r.roughness())) +
                       element("float", "eta", number(std::max(r.shape(Role::index), 1.0 + 1e-6)));
  if (r.anisotropic())
    inside += element("float", "anisotropic", number((1 - r.alpha_y() / r.alpha_x()) / 0.9));
  return bsdf("principled", id, inside);
}

}  // namespace

std::string write_mitsuba(const Written& w) {
  const std::string id = "id=\"" + identifier(w.name) + "\"";
  const Reading first(w.parts.front());
  const bool sum = first.has_weight(Role::specular);
  if (!sum && w.parts.size() > 1) throw InputError("principled has a single lobe of this kind");
  for (const WrittenPart& part : w.parts)
    if (const Reading r(part); !r.along_tangent() && !(sum && r.crosswise())) r.refuse_turn();
  return xml_header(w.header) + "<scene version=\"3.0.0\">\n" + (sum ? mixed(w, id) : principled(first, id)) +
         "</scene>\n";
}

}  // namespace brdf::interop
