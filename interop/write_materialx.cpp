#include <algorithm>
#include <cmath>
#include <numbers>

#include "interop/materialx_graph.h"
#include "interop/reading.h"
#include "io/files/error.h"

namespace brdf::interop {
namespace {

void diffuse_node(const Reading& r, Graph& graph, const std::string& name) {
  graph.begin("oren_nayar_diffuse_bsdf", "BSDF", name);
  graph.value("weight", "float", "1");
  graph.value("color", "color3", numbers(r.weight(Role::diffuse)));
  graph.value("roughness", "float", number(r.shape(Role::slope)));
  graph.value("energy_compensation", "boolean", "false");
  graph.end();
}

// Writes Tworld turned about Nworld; the node turns clockwise.
void tangent_nodes(const Reading& r, Graph& graph, const std::string& number_of) {
  for (const char* vector : {"tangent", "normal"}) {
    graph.begin(vector, "vector3", vector + number_of);
    graph.value("space", "string", "world");
    graph.end();
  }
  graph.begin("rotate3d", "vector3", "turned" + number_of);
  graph.link("in", "vector3", "tangent" + number_of);
  graph.value("amount", "float", number(-r.turn()));
  graph.link("axis", "vector3", "normal" + number_of);
  graph.end();
}

void lobe_node(const Reading& r, Graph& graph, const std::string& number_of) {
  r.check_widths(1e-4, 1e4, "nothing");
  if (r.turn() != 0) tangent_nodes(r, graph, number_of);
  graph.begin("generalized_schlick_bsdf", "BSDF", "lobe" + number_of);
  graph.value("weight", "float", number(r.weight(Role::specular)[0]));
  graph.value("color0", "color3", numbers(r.shape_colours(Role::f0)));
  graph.value("color82", "color3", "1, 1, 1");
  graph.value("color90", "color3", "1, 1, 1");
  graph.value("exponent", "float", "5");
  graph.value("roughness", "vector2", number(r.alpha_x()) + ", " + number(r.alpha_y()));
  if (r.turn() != 0) graph.link("tangent", "vector3", "turned" + number_of);
  graph.value("distribution", "string", "ggx");
  graph.value("scatter_mode", "string", "R");
  graph.end();
}

// A surface node: its name in MaterialX, and its inputs.
struct SurfaceNode {
  const char* node;
  std::vector<std::pair<const char*, double>> numbers;
  std::vector<std::pair<const char*, Colour>> colours;
  const char* tangent;  // its input for the tangent, or null: the tangent is that of the mesh
};

// Returns 1 - alpha_y/alpha_x, from which these nodes compute the ratio of the widths.
double narrowing(const Reading& r) {
  return 1 - r.alpha_y() / r.alpha_x();
}

SurfaceNode open_pbr_node(const Reading& r) {
  // alpha_x = roughness^2 sqrt(2/(1 + (alpha_y/alpha_x)^2))
  const double roughness = std::pow((r.alpha_x() * r.alpha_x() + r.alpha_y() * r.alpha_y()) / 2, 0.25);
  return {"open_pbr_surface",
          {{"base_weight", 1},
           {"base_diffuse_roughness", r.shape("diffuse_roughness")},
           {"base_metalness", r.metallic()},
           {"specular_weight", r.shape(Role::specular)},
           {"specular_roughness", roughness},
           {"specular_ior", r.shape(Role::index)},
           {"specular_roughness_anisotropy", narrowing(r)}},
          {{"base_color", r.colour(Role::diffuse)}, {"specular_color", {1, 1, 1}}},
          "geometry_tangent"};
}

SurfaceNode standard_surface_node(const Reading& r) {
  r.check_widths(1e-4, 50, "specular_anisotropy");
  return {"standard_surface",
          {{"base", 1},
           {"diffuse_roughness", r.shape(Role::slope)},
           {"metalness", r.metallic()},
           {"specular", r.shape(Role::specular)},
           {"specular_roughness", r.roughness()},
           {"specular_IOR", r.shape(Role::index)},
           {"specular_anisotropy", narrowing(r)}},
          {{"base_color", r.colour(Role::diffuse)}, {"specular_color", {1, 1, 1}}},
          "tangent"};
}

SurfaceNode gltf_pbr_node(const Reading& r) {
  return {"gltf_pbr",
          {{"metallic", r.metallic()},
           {"roughness", std::sqrt(r.alpha_y())},
           {"ior", r.shape(Role::index)},
           {"specular", r.shape(Role::specular)},
           {"anisotropy_strength", r.anisotropy_strength()},
           {"anisotropy_rotation", r.turn() * std::numbers::pi / 180}},
          {{"base_color", r.colour(Role::diffuse)}, {"specular_color", {1, 1, 1}}},
          nullptr};
}

SurfaceNode usd_preview_node(const Reading& r) {
  const Colour colour = r.colour(Role::diffuse);
  if (const double metallic = r.metallic(); metallic > 0 && metallic < 1 && !is_grey(colour))
    throw InputError(
        "metallic " + number(metallic) +
        " of a coloured material: UsdPreviewSurface darkens the base by the mean of the colours, "
        "which the target does not know; metallic must be 0 or 1");
  return {"UsdPreviewSurface",
          {{"metallic", r.metallic()}, {"roughness", std::sqrt(r.alpha_x())}, {"ior", r.shape(Role::index)}},
          {{"diffuseColor", colour}},
          nullptr};
}

SurfaceNode disney_node(const Reading& r) {
  r.check_widths(1e-4, 50, "anisotropic");
  if (!r.along_tangent())
    throw InputError(
        "the node widens the lobe along the mesh's dp/du: orient dp/du at " + number(r.turn()) +
        " degrees from the surface's x axis, counter-clockwise seen from outside, and export with "
        "the larger width as alpha_x and tangent_phi 0");
  return {"disney_principled",
          {{"metallic", r.metallic()},
           {"roughness", r.roughness()},
           {"anisotropic", narrowing(r)},
           {"specular", r.shape(Role::f0) / 0.08}},
          {{"baseColor", r.colour(Role::diffuse)}},
          nullptr};
}

std::string write_node(const Written& w, SurfaceNode (*node_of)(const Reading&)) {
  const Reading r(w.parts.front());
  r.check_widths(1e-4, 1e4, "nothing");
  r.check_wider_along("the node");
  const SurfaceNode node = node_of(r);
  Graph graph(w.name);
  const bool turned = node.tangent && r.turn() != 0;
  if (turned) tangent_nodes(r, graph, "");
  graph.begin(node.node, "surfaceshader", "surface");
  for (const auto& [input, value] : node.numbers) graph.value(input, "float", number(value));
  for (const auto& [input, value] : node.colours) graph.value(input, "color3", numbers(value));
  if (turned) graph.link(node.tangent, "vector3", "turned");
  graph.end();
  return document(w.header, graph);
}

}  // namespace

std::string document(const std::vector<std::string>& header, Graph& graph) {
  graph.begin("surfacematerial", "material", "");
  graph.link("surfaceshader", "surfaceshader", "surface");
  graph.end();
  return "<?xml version=\"1.0\"?>\n" + xml_header(header) +
         "<materialx version=\"1.39\" colorspace=\"lin_rec709\">\n" + graph.text() + "</materialx>\n";
}

std::string write_open_pbr_surface(const Written& w) {
  return write_node(w, open_pbr_node);
}
std::string write_standard_surface(const Written& w) {
  return write_node(w, standard_surface_node);
}
std::string write_gltf_pbr(const Written& w) {
  return write_node(w, gltf_pbr_node);
}
std::string write_usd_preview_surface(const Written& w) {
  return write_node(w, usd_preview_node);
}
std::string write_disney_principled(const Written& w) {
  return write_node(w, disney_node);
}

std::string write_materialx(const Written& w) {
  Graph graph(w.name);
  std::string last;
  const auto add = [&](const std::string& node) {
    if (last.empty()) {
      last = node;
      return;
    }
    const std::string sum = "sum" + (last.starts_with("sum") ? "_with_" + node : std::string());
    graph.begin("add", "BSDF", sum);
    graph.link("in1", "BSDF", last);
    graph.link("in2", "BSDF", node);
    graph.end();
    last = sum;
  };
  for (std::size_t k = 0; k < w.parts.size(); ++k) {
    const Reading r(w.parts[k]);
    const std::string number_of = k > 0 ? std::to_string(k + 1) : "";
    const bool lobe = !is_black(r.weight(Role::specular));
    if (!is_black(r.weight(Role::diffuse)) || (!lobe && w.parts.size() == 1)) {
      diffuse_node(r, graph, "diffuse" + number_of);
      add("diffuse" + number_of);
    }
    if (!lobe) continue;
    lobe_node(r, graph, number_of);
    add("lobe" + number_of);
  }
  graph.begin("surface", "surfaceshader", "surface");
  graph.link("bsdf", "BSDF", last);
  graph.end();
  return document(w.header, graph);
}

}  // namespace brdf::interop
