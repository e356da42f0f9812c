// Build step: writes brdf.glsl (every form of the catalogue, traced), texture_rule.glsl and the probe's
// compute shader (and its negative control, without `precise`) into a folder.
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "brdf/trace.h"
#include "render/scene/texture_rule.h"

namespace {

// A form's number in the shaders is its place in the catalogue,
// a specialisation constant, so that the driver keeps one case.
std::vector<brdf::NumberedReflectance> numbered() {
  std::vector<brdf::NumberedReflectance> list;
  for (const brdf::Reflectance& form : brdf::catalogue()) list.push_back({int(list.size()), form});
  return list;
}

std::string forms(const brdf::GlslOptions& options = {}) {
  std::string text = brdf::glsl_kernels(options);
  for (const brdf::Reflectance& form : brdf::catalogue()) text += form->glsl(options);
  return text + brdf::glsl_dispatch("brdf_eval_cos", numbered());
}

// The compute shader of the probe (render/proof/shader_proof.h): evaluates one form on many configurations.
std::string probe(const brdf::GlslOptions& options) {
  return R"(#version 450
layout(local_size_x = 64) in;
layout(constant_id = 0) const int form = 0;
layout(std430, binding = 0) readonly buffer Configurations { vec4 configuration[]; };
layout(std430, binding = 1) writeonly buffer Results { vec4 result[]; };
layout(push_constant) uniform Push { uint count; };
)" + forms(options) +
         brdf::glsl_dispatch("brdf_eval", numbered()) + R"(
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  vec3 wi = configuration[6 * i].xyz, wo = configuration[6 * i + 1].xyz;
  vec4 shape = configuration[6 * i + 2];
  vec3 w0 = configuration[6 * i + 3].xyz, w1 = configuration[6 * i + 4].xyz, w2 = configuration[6 * i + 5].xyz;
  result[2 * i] = vec4(brdf_eval(form, wi, wo, shape, w0, w1, w2), 0.0);
  result[2 * i + 1] = vec4(brdf_eval_cos(form, wi, wo, shape, w0, w1, w2), 0.0);
}
)";
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
  if (write(folder + "/brdf.glsl", forms()) && write(folder + "/texture_rule.glsl", texture_rule()) &&
      write(folder + "/probe.comp", probe({})) &&
      write(folder + "/probe_unprecise.comp", probe({.precise = false})))
    return 0;
  std::fprintf(stderr, "emit_shaders: cannot write into %s\n", argv[1]);
  return 1;
}
