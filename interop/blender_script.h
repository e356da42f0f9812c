// Statements of Blender's Python that make the nodes of a material.
#pragma once

#include <cmath>
#include <string>

#include "interop/reading.h"
#include "io/files/json.h"

namespace brdf::interop {

// Statements of the Python function that makes the nodes.
class Script {
 public:
  // Adds a node with its enum properties.
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
  // Links the tangent vector to a node that turns the vector by `degrees` about the normal.
  void tangent(const std::string& variable, const std::string& rotation, double degrees) {
    line("tree.links.new(tangent_of(tree, tangent), " + variable + ".inputs[\"Tangent\"])");
    set(variable, rotation, degrees / 360 - std::floor(degrees / 360));
  }
  // Adds an Image Texture of a file next to the script, read at the nearest texel without conversion of
  // colours.
  void image(const std::string& variable, const std::string& file) {
    node(variable, "TexImage", "interpolation = \"Closest\"");
    line(variable + ".extension = \"EXTEND\"");
    line(variable + ".image = bpy.data.images.load(os.path.join(folder, " + quoted(file) + "))");
    line(variable + ".image.colorspace_settings.name = \"Non-Color\"");
  }
  const std::string& text() const { return text_; }

 private:
  static std::string quoted(const std::string& text) { return io::to_line(io::Json(text)); }

  std::string text_;
};

}  // namespace brdf::interop
