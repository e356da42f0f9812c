// Build step: writes brdf.glsl (every form of the catalogue, traced) and texture_rule.glsl into a folder.
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "brdf/trace.h"
#include "render/texture_rule.h"

namespace {

// One function that picks the form; `form` is a specialisation constant, so the driver keeps one case.
std::string dispatch() {
  std::string text =
      "vec3 brdf_eval_cos(int form, vec3 wi, vec3 wo, vec4 shape, vec3 w0, vec3 w1, vec3 w2) {\n  switch "
      "(form) {\n";
  int index = 0;
  brdf::for_each_form([&](auto form) {
    const brdf::FormInfo& info = brdf::info(brdf::AnyForm(form));
    text += "    case " + std::to_string(index++) + ": return brdf_eval_cos_" + std::string(info.name) +
            "(wi, wo";
    for (std::size_t k = 0; k < info.shape.size(); ++k) text += ", shape[" + std::to_string(k) + "]";
    for (std::size_t k = 0; k < info.weights.size(); ++k) text += ", w" + std::to_string(k);
    text += ");\n";
  });
  return text + "  }\n  return vec3(0.0);\n}\n";
}

std::string forms() {
  std::string text = brdf::glsl_kernels();
  brdf::for_each_form([&](auto form) { text += brdf::glsl_form(brdf::AnyForm(form)); });
  return text + dispatch();
}

std::string texture_rule() {
  using brdf::Traced;
  std::string text =
      "float driven(int role, float own, float albedo, float roughness, float metallic) {\n  switch (role) "
      "{\n";
  for (int role = 0; role < brdf::render::kRoleCount; ++role) {
    brdf::Trace trace;
    const brdf::Trace::Scope scope(trace);
    const Traced value =
        brdf::render::driven(brdf::render::Role(role), Traced::input("own"), Traced::input("albedo"),
                             Traced::input("roughness"), Traced::input("metallic"));
    text += "  case " + std::to_string(role) + ": {\n" +
            trace.statements({value.node()}, "return %0;", true) + "  }\n";
  }
  return text + "  }\n  return own;\n}\n";
}

bool write(const std::string& path, const std::string& text) {
  std::ofstream out(path);
  return bool(out << text) && bool(out.flush());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: emit_shaders FOLDER\n");
    return 2;
  }
  const std::string folder = argv[1];
  if (write(folder + "/brdf.glsl", forms()) && write(folder + "/texture_rule.glsl", texture_rule())) return 0;
  std::fprintf(stderr, "emit_shaders: cannot write into %s\n", argv[1]);
  return 1;
}
