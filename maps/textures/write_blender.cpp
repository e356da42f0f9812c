#include "interop/blender_script.h"
#include "maps/textures/written.h"

namespace brdf::maps {
namespace {

using interop::Script;

// The plane has the first texel at its upper left corner, and texture coordinates from 0 to 1.
constexpr const char* kPlane = R"(

def make_plane(material):
    """Returns a plane in z = 0 that shows the material."""
    x, y = WIDTH / 2, HEIGHT / 2
    mesh = bpy.data.meshes.new(material.name)
    mesh.from_pydata([(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)], [], [(0, 1, 2, 3)])
    layer = mesh.uv_layers.new()
    for corner, place in zip(layer.data, [(0, 0), (1, 0), (1, 1), (0, 1)]):
        corner.uv = place
    mesh.materials.append(material)
    plane = bpy.data.objects.new(material.name, mesh)
    bpy.context.collection.objects.link(plane)
    return plane


if __name__ == "__main__":
    make_plane(make_material())
)";

// Adds the nodes of the material.
class BlenderNodes {
 public:
  BlenderNodes(const Carried& carried, ImageFiles& images, Script& script)
      : carried_(carried), images_(images), s_(script) {
    if (!carried.has_normals) return;
    s_.image("normal_texels", images.add_normals());
    s_.node("normal", "NormalMap");
    s_.link("normal_texels", "normal", "\"Color\"");
  }

  // Sets an input of a node to the value of an input map, or links it with the map's image.
  void put(const std::string& node, const char* node_input, std::string_view name) {
    const InputMap& map = carried_.input(name);
    if (!map.constant) {
      const std::string variable = std::string(name) + "_texels";
      s_.image(variable, images_.add(map));
      s_.link(variable, node, "\"" + std::string(node_input) + "\"");
      return;
    }
    const auto at = [&](std::size_t c) { return map.factors[map.factors.size() == 1 ? 0 : c]; };
    if (map.input.coloured)
      s_.set(node, node_input, interop::Colour{at(0), at(1), at(2)});
    else
      s_.set(node, node_input, at(0));
  }
  void put_normal(const std::string& node) {
    if (carried_.has_normals) s_.link("normal", node, "\"Normal\"");
  }

  void principled() {
    s_.node("principled", "BsdfPrincipled", "distribution = \"GGX\"");
    put("principled", "Base Color", "base_color");
    put("principled", "Metallic", "metallic");
    put("principled", "Specular", "specular");
    put("principled", "Roughness", "roughness");
    for (const char* off : {"Subsurface", "Specular Tint", "Sheen", "Clearcoat", "Transmission"})
      s_.set("principled", off, 0);
    put_normal("principled");
    finish("principled");
  }

  void sum_with(const std::string& lobe) {
    s_.node("diffuse", "BsdfDiffuse");
    put("diffuse", "Color", "kd");
    s_.set("diffuse", "Roughness", 0);
    put_normal("diffuse");
    s_.node("sum", "AddShader");
    s_.link("diffuse", "sum", "0");
    s_.link(lobe, "sum", "1");
    finish("sum");
  }

  void glossy() {
    s_.node("glossy", "BsdfGlossy", "distribution = \"GGX\"");
    put("glossy", "Color", "ks");
    put("glossy", "Roughness", "roughness");
    put_normal("glossy");
    sum_with("glossy");
  }

  void metallic() {
    s_.node("metallic", "BsdfMetallic", "distribution = \"GGX\"");
    s_.line("metallic.fresnel_type = \"F82\"");
    put("metallic", "Base Color", "f0");
    s_.set("metallic", "Edge Tint", interop::Colour{1, 1, 1});
    put("metallic", "Roughness", "roughness");
    put_normal("metallic");
    s_.node("black", "BsdfDiffuse");
    s_.set("black", "Color", interop::Colour{0, 0, 0});
    s_.node("share", "MixShader");
    put("share", "Fac", "ks");
    s_.link("black", "share", "1");
    s_.link("metallic", "share", "2");
    sum_with("share");
  }

 private:
  // Texels that are not held are transparent.
  void finish(const std::string& last) {
    if (carried_.is_whole()) {
      s_.link(last, "output", "\"Surface\"");
      return;
    }
    s_.image("held_texels", images_.add_held());
    s_.node("hole", "BsdfTransparent");
    s_.node("shown", "MixShader");
    s_.link("held_texels", "shown", "\"Fac\"");
    s_.link("hole", "shown", "1");
    s_.link(last, "shown", "2");
    s_.link("shown", "output", "\"Surface\"");
  }

  const Carried& carried_;
  ImageFiles& images_;
  Script& s_;
};

}  // namespace

std::string script_of(const Carried& carried, ImageFiles& images, const Description& described,
                      const std::array<double, 2>& size) {
  Script script;
  BlenderNodes nodes(carried, images, script);
  const std::string_view target = info(carried.target).name;
  target == "blender_principled" ? nodes.principled()
  : target == "blender_glossy"   ? nodes.glossy()
                                 : nodes.metallic();
  return interop::comments(described.header, "# ") +
         "# blender --python FILE makes a plane with the material; the images lie in the folder of this "
         "file.\n"
         "import os\n\nimport bpy\n\n"
         "FOLDER = os.path.dirname(os.path.abspath(__file__)) if \"__file__\" in globals() else "
         "bpy.path.abspath(\"//\")\n"
         "WIDTH, HEIGHT = " +
         interop::number(size[0]) + ", " + interop::number(size[1]) + "\n\n\ndef make_material(name=\"" +
         interop::identifier(described.name) +
         "\", folder=FOLDER):\n"
         "    material = bpy.data.materials.new(name)\n"
         "    material.use_nodes = True\n"
         "    tree = material.node_tree\n"
         "    tree.nodes.clear()\n"
         "    output = tree.nodes.new(\"ShaderNodeOutputMaterial\")\n" +
         script.text() + "    return material\n" + kPlane;
}

}  // namespace brdf::maps
