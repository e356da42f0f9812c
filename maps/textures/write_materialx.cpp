#include <algorithm>

#include "interop/materialx_graph.h"
#include "maps/textures/written.h"

namespace brdf::maps {
namespace {

using interop::Graph;

// Writes the numbers of the inputs as values, or as images that the nodes of the material read.
class MaterialxInputs {
 public:
  MaterialxInputs(const Carried& carried, ImageFiles& images, Graph& graph)
      : carried_(carried), graph_(graph) {
    for (const InputMap& map : carried.inputs)
      if (!map.constant) graph.image(type_of(map), std::string(map.input.name), images.add(map));
    if (!carried.is_whole()) graph.image("float", "held", images.add_held());
    if (!carried.has_normals) return;
    graph.image("vector3", "normal_texels", images.add_normals());
    graph.begin("normalmap", "vector3", "normal");
    graph.link("in", "vector3", "normal_texels");
    graph.end();
  }

  // Writes an input of a node.
  void put(const char* node_input, std::string_view name) {
    const InputMap& map = carried_.input(name);
    const char* const type = type_of(map);
    if (!map.constant) {
      graph_.link(node_input, type, std::string(name));
      return;
    }
    std::string text;
    for (std::size_t c = 0; c < (map.input.coloured ? 3 : map.input.role == Role::width ? 2 : 1); ++c)
      text += (c > 0 ? ", " : "") + interop::number(map.factors[map.factors.size() == 1 ? 0 : c]);
    graph_.value(node_input, type, text);
  }
  void put_normal() {
    if (carried_.has_normals) graph_.link("normal", "vector3", "normal");
  }
  bool is_black(std::string_view name) const {
    const InputMap& map = carried_.input(name);
    return map.constant && std::ranges::max(map.factors) == 0;
  }

 private:
  // Both widths of the lobe are those of the texel.
  static const char* type_of(const InputMap& map) {
    return map.input.coloured ? "color3" : map.input.role == Role::width ? "vector2" : "float";
  }

  const Carried& carried_;
  Graph& graph_;
};

}  // namespace

std::string mtlx_of(const Carried& carried, ImageFiles& images, const Description& described) {
  Graph graph(described.name);
  MaterialxInputs inputs(carried, images, graph);
  const bool lobe = !inputs.is_black("ks"), diffuse = !inputs.is_black("kd") || !lobe;
  if (diffuse) {
    graph.begin("oren_nayar_diffuse_bsdf", "BSDF", "diffuse");
    graph.value("weight", "float", "1");
    inputs.put("color", "kd");
    inputs.put("roughness", "sigma");
    inputs.put_normal();
    graph.value("energy_compensation", "boolean", "false");
    graph.end();
  }
  if (lobe) {
    graph.begin("generalized_schlick_bsdf", "BSDF", "lobe");
    inputs.put("weight", "ks");
    inputs.put("color0", "f0");
    graph.value("color82", "color3", "1, 1, 1");
    graph.value("color90", "color3", "1, 1, 1");
    graph.value("exponent", "float", "5");
    inputs.put("roughness", "alpha");
    inputs.put_normal();
    graph.value("distribution", "string", "ggx");
    graph.value("scatter_mode", "string", "R");
    graph.end();
  }
  if (lobe && diffuse) {
    graph.begin("add", "BSDF", "sum");
    graph.link("in1", "BSDF", "diffuse");
    graph.link("in2", "BSDF", "lobe");
    graph.end();
  }
  graph.begin("surface", "surfaceshader", "surface");
  graph.link("bsdf", "BSDF", lobe && diffuse ? "sum" : lobe ? "lobe" : "diffuse");
  if (!carried.is_whole()) graph.link("opacity", "float", "held");
  graph.end();
  return interop::document(described.header, graph);
}

}  // namespace brdf::maps
