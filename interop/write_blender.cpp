#include <cmath>

#include "interop/reading.h"
#include "interop/writers.h"

namespace brdf::interop {
namespace {

// Cycles takes alpha_x alpha_y <= 1e-7 for a mirror.
constexpr double kLeastAlpha = 3.17e-4;

// Statements of the function that makes the nodes.
class Script {
 public:
  // A node with its enum properties and the values of its inputs.
  void node(const std::string& variable, const std::string& type, const std::string& properties = "") {
    line(variable + " = tree.nodes.new(\"ShaderNode" + type + "\")");
    if (!properties.empty()) line(variable + "." + properties);
  }
  void set(const std::string& variable, const std::string& input, double value) {
    line(variable + ".inputs[\"" + input + "\"].default_value = " + number(value));
  }
  void set(const std::string& variable, const std::string& input, const Colour& colour) {
    line(variable + ".inputs[\"" + input + "\"].default_value = (" + numbers(colour) + ", 1)");
  }
  void link(const std::string& from, const std::string& to, const std::string& input) {
    line("tree.links.new(" + from + ".outputs[0], " + to + ".inputs[" + input + "])");
  }
  void line(const std::string& statement) { text_ += "    " + statement + "\n"; }
  // The tangent's vector into a node that turns it by degrees about the normal.
  void tangent(const std::string& variable, const std::string& rotation, double degrees) {
    line("tree.links.new(tangent_of(tree, tangent), " + variable + ".inputs[\"Tangent\"])");
    set(variable, rotation, degrees / 360 - std::floor(degrees / 360));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

constexpr const char* kTangent = R"(
def tangent_of(tree, tangent):
    """A socket with the surface's tangent: a vector in world space, or that of the UV map where none is given."""
    if tangent is None:
        node = tree.nodes.new("ShaderNodeTangent")
        node.direction_type = "UV_MAP"
        return node.outputs[0]
    node = tree.nodes.new("ShaderNodeCombineXYZ")
    for k in range(3):
        node.inputs[k].default_value = tangent[k]
    return node.outputs[0]

)";

std::string script(const Written& w, const Script& nodes, bool turned) {
  return comments(w.header, "# ") +
         "# In Blender's text editor, or blender --python FILE; then assign the material to an object.\n"
         "import bpy\n\n" +
         (turned ? kTangent : "") + "\ndef make_material(name=\"" + identifier(w.name) +
         "\", tangent=None):\n"
         "    material = bpy.data.materials.new(name)\n"
         "    material.use_nodes = True\n"
         "    tree = material.node_tree\n"
         "    tree.nodes.clear()\n"
         "    output = tree.nodes.new(\"ShaderNodeOutputMaterial\")\n" +
         nodes.text() +
         "    return material\n\n\n"
         "if __name__ == \"__main__\":\n    make_material()\n";
}

void diffuse(Script& s, const Colour& colour) {
  s.node("diffuse", "BsdfDiffuse");
  s.set("diffuse", "Color", colour);
  s.set("diffuse", "Roughness", 0);
}

// Diffuse and lobe added; one alone where the other is black.
void sum(Script& s, const Colour& kd, const std::string& lobe) {
  if (is_black(kd) && !lobe.empty()) {
    s.link(lobe, "output", "\"Surface\"");
    return;
  }
  diffuse(s, kd);
  if (lobe.empty()) {
    s.link("diffuse", "output", "\"Surface\"");
    return;
  }
  s.node("add", "AddShader");
  s.link("diffuse", "add", "0");
  s.link(lobe, "add", "1");
  s.link("add", "output", "\"Surface\"");
}

std::string glossy(const Written& w) {
  const Reading r(w);
  const Colour ks = r.weight(Role::specular);
  Script s;
  const bool turned = r.anisotropic() && !is_black(ks);
  if (!is_black(ks)) {
    r.check_widths(kLeastAlpha, 1e4, "Anisotropy");
    s.node("glossy", turned ? "BsdfAnisotropic" : "BsdfGlossy", "distribution = \"GGX\"");
    s.set("glossy", "Color", ks);
    s.set("glossy", "Roughness", r.roughness());
    // A < 0: alpha_x = roughness^2/(1 + A), alpha_y = roughness^2 (1 + A).
    if (turned) s.set("glossy", "Anisotropy", std::sqrt(r.alpha_y() / r.alpha_x()) - 1);
    if (turned) s.tangent("glossy", "Rotation", r.turn());
  }
  sum(s, r.weight(Role::diffuse), is_black(ks) ? "" : "glossy");
  return script(w, s, turned);
}

std::string principled(const Written& w) {
  const Reading r(w);
  r.check_widths(kLeastAlpha, 10, "Anisotropic");
  const double eta = r.shape(Role::index), root = (eta - 1) / (eta + 1);
  Script s;
  s.node("principled", "BsdfPrincipled", "distribution = \"GGX\"");
  s.set("principled", "Base Color", r.weight(Role::diffuse));
  s.set("principled", "Metallic", r.metallic());
  s.set("principled", "Specular", root * root / 0.08);
  s.set("principled", "Roughness", r.roughness());
  for (const char* off : {"Subsurface", "Specular Tint", "Sheen", "Clearcoat", "Transmission"})
    s.set("principled", off, 0);
  // alpha_x/alpha_y = 1/(1 - .9 A)
  if (r.anisotropic()) s.set("principled", "Anisotropic", (1 - r.alpha_y() / r.alpha_x()) / 0.9);
  if (r.anisotropic()) s.tangent("principled", "Anisotropic Rotation", r.turn());
  s.link("principled", "output", "\"Surface\"");
  return script(w, s, r.anisotropic());
}

}  // namespace

std::string write_blender(const Written& w) {
  const Reading r(w);
  const double ks = r.weight(Role::specular)[0];
  Script s;
  const bool turned = r.anisotropic() && ks > 0;
  if (ks > 0) {
    r.check_widths(kLeastAlpha, 10, "Anisotropy");
    s.node("metallic", "BsdfMetallic", "distribution = \"GGX\"");
    s.line("metallic.fresnel_type = \"F82\"");
    s.set("metallic", "Base Color", r.weight(Role::f0));
    s.set("metallic", "Edge Tint", {1, 1, 1});
    s.set("metallic", "Roughness", r.roughness());
    if (turned) s.set("metallic", "Anisotropy", (1 - r.alpha_y() / r.alpha_x()) / 0.9);
    if (turned) s.tangent("metallic", "Rotation", r.turn());
  }
  std::string lobe = ks > 0 ? "metallic" : "";
  if (ks > 0 && ks < 1) {
    s.node("black", "BsdfDiffuse");
    s.set("black", "Color", {0, 0, 0});
    s.node("share", "MixShader");
    s.set("share", "Fac", ks);
    s.link("black", "share", "1");
    s.link("metallic", "share", "2");
    lobe = "share";
  }
  sum(s, r.weight(Role::diffuse), lobe);
  return script(w, s, turned);
}

std::string write_blender_3_4(const Written& w) {
  return Reading(w).has_weight(Role::specular) ? glossy(w) : principled(w);
}

}  // namespace brdf::interop
