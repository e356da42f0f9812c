#include <cmath>

#include "interop/blender_script.h"
#include "interop/reading.h"

namespace brdf::interop {
namespace {

// Cycles treats alpha_x alpha_y <= 1e-7 as a mirror.
constexpr double kLeastAlpha = 3.17e-4;

constexpr const char* kTangent = R"(
def tangent_of(tree, tangent):
    """Returns a socket with the tangent: the given vector in world space, or the tangent of the UV map."""
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

// Adds the shaders of the surface one after the other.
class Sum {
 public:
  explicit Sum(Script& script) : s_(script) {}
  void add(const std::string& node) {
    if (!last_.empty()) {
      const std::string sum = "sum_" + std::to_string(++sums_);
      s_.node(sum, "AddShader");
      s_.link(last_, sum, "0");
      s_.link(node, sum, "1");
      last_ = sum;
    } else {
      last_ = node;
    }
  }
  void add_diffuse(const std::string& node, const Colour& colour) {
    s_.node(node, "BsdfDiffuse");
    s_.set(node, "Color", colour);
    s_.set(node, "Roughness", 0);
    add(node);
  }
  // Completes the surface. A surface without shaders is black.
  void finish() {
    if (last_.empty()) add_diffuse("diffuse", {0, 0, 0});
    s_.link(last_, "output", "\"Surface\"");
  }

 private:
  Script& s_;
  std::string last_;
  int sums_ = 0;
};

// The node of a lobe. If the widths differ, the surface's tangent sets its axis.
struct Lobe {
  std::string node;
  bool turned = false;
};

// Returns the lobe of one part; its node is empty if the lobe is black. `suffix` distinguishes the nodes of
// different parts.
using LobeOf = Lobe (*)(const Reading& r, Script& s, const std::string& suffix);

std::string sum_of_parts(const Written& w, LobeOf lobe_of) {
  Script s;
  Sum sum(s);
  bool turned = false;
  for (std::size_t k = 0; k < w.parts.size(); ++k) {
    const Reading r(w.parts[k]);
    const std::string suffix = k > 0 ? "_" + std::to_string(k + 1) : "";
    if (const Colour kd = r.weight(Role::diffuse); !is_black(kd)) sum.add_diffuse("diffuse" + suffix, kd);
    const Lobe lobe = lobe_of(r, s, suffix);
    if (!lobe.node.empty()) sum.add(lobe.node);
    turned = turned || lobe.turned;
  }
  sum.finish();
  return script(w, s, turned);
}

Lobe glossy(const Reading& r, Script& s, const std::string& suffix) {
  const Colour ks = r.weight(Role::specular);
  if (is_black(ks)) return {};
  const std::string node = "glossy" + suffix;
  r.check_widths(kLeastAlpha, 1e4, "Anisotropy");
  s.node(node, r.anisotropic() ? "BsdfAnisotropic" : "BsdfGlossy", "distribution = \"GGX\"");
  s.set(node, "Color", ks);
  s.set(node, "Roughness", r.roughness());
  if (!r.anisotropic()) return {node};
  // A < 0: alpha_x = roughness^2/(1 + A), alpha_y = roughness^2 (1 + A).
  s.set(node, "Anisotropy", std::sqrt(r.alpha_y() / r.alpha_x()) - 1);
  s.tangent(node, "Rotation", r.turn());
  return {node, true};
}

Lobe metallic(const Reading& r, Script& s, const std::string& suffix) {
  const double ks = r.weight(Role::specular)[0];
  if (ks == 0) return {};
  const std::string node = "metallic" + suffix, black = "black" + suffix, share = "share" + suffix;
  r.check_widths(kLeastAlpha, 10, "Anisotropy");
  s.node(node, "BsdfMetallic", "distribution = \"GGX\"");
  s.line(node + ".fresnel_type = \"F82\"");
  s.set(node, "Base Color", r.weight(Role::f0));
  s.set(node, "Edge Tint", {1, 1, 1});
  s.set(node, "Roughness", r.roughness());
  const bool turned = r.anisotropic();
  if (turned) s.set(node, "Anisotropy", (1 - r.alpha_y() / r.alpha_x()) / 0.9);
  if (turned) s.tangent(node, "Rotation", r.turn());
  if (ks == 1) return {node, turned};
  s.node(black, "BsdfDiffuse");
  s.set(black, "Color", {0, 0, 0});
  s.node(share, "MixShader");
  s.set(share, "Fac", ks);
  s.link(black, share, "1");
  s.link(node, share, "2");
  return {share, turned};
}

std::string principled(const Written& w) {
  const Reading r(w.parts.front());
  if (w.parts.size() > 1) throw InputError("Principled BSDF has a single lobe of this kind");
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
  return sum_of_parts(w, metallic);
}

std::string write_blender_3_4(const Written& w) {
  return Reading(w.parts.front()).has_weight(Role::specular) ? sum_of_parts(w, glossy) : principled(w);
}

}  // namespace brdf::interop
