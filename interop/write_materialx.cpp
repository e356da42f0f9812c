#include "interop/reading.h"

namespace brdf::interop {
namespace {

// The nodes of the document. Each follows the nodes that it uses.
class Graph {
 public:
  explicit Graph(const Written& w) : name_(identifier(w.name)) {}

  void begin(const char* node, const char* type, const std::string& name) {
    node_ = node;
    text_ += "  <" + node_ + " name=\"" + named(name) + "\" type=\"" + type + "\">\n";
  }
  void value(const char* input, const char* type, const std::string& text) {
    put(input, type, "value", text);
  }
  void link(const char* input, const char* type, const std::string& from) {
    put(input, type, "nodename", named(from));
  }
  void end() { text_ += "  </" + node_ + ">\n"; }
  const std::string& text() const { return text_; }

 private:
  std::string named(const std::string& part) const { return part.empty() ? name_ : name_ + "_" + part; }
  void put(const char* input, const char* type, const char* attribute, const std::string& text) {
    text_ += "    <input name=\"" + std::string(input) + "\" type=\"" + type + "\" " + attribute + "=\"" +
             text + "\"/>\n";
  }

  std::string name_, node_, text_;
};

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

}  // namespace

std::string write_materialx(const Written& w) {
  Graph graph(w);
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
  graph.begin("surfacematerial", "material", "");
  graph.link("surfaceshader", "surfaceshader", "surface");
  graph.end();
  return "<?xml version=\"1.0\"?>\n" + xml_header(w.header) +
         "<materialx version=\"1.39\" colorspace=\"lin_rec709\">\n" + graph.text() + "</materialx>\n";
}

}  // namespace brdf::interop
