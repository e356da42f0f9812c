// Nodes of a MaterialX document.
#pragma once

#include <string>
#include <vector>

#include "interop/reading.h"
#include "io/page/html_report.h"

namespace brdf::interop {

// The nodes of the document. Each follows the nodes that it uses.
class Graph {
 public:
  explicit Graph(const std::string& name) : name_(identifier(name)) {}

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
  // Adds an image that is read at the nearest texel without conversion of colours.
  void image(const char* type, const std::string& name, const std::string& file) {
    begin("image", type, name);
    value("file", "filename", io::html_escaped(file));
    value("filtertype", "string", "closest");
    for (const char* mode : {"uaddressmode", "vaddressmode"}) value(mode, "string", "clamp");
    end();
  }
  const std::string& text() const { return text_; }

 private:
  std::string named(const std::string& part) const { return part.empty() ? name_ : name_ + "_" + part; }
  void put(const char* input, const char* type, const char* attribute, const std::string& text) {
    text_ += "    <input name=\"" + std::string(input) + "\" type=\"" + type + "\" " + attribute + "=\"" +
             text + "\"/>\n";
  }

  std::string name_, node_, text_;
};

// Returns the document around nodes of which the last one is the surface.
std::string document(const std::vector<std::string>& header, Graph& graph);

}  // namespace brdf::interop
