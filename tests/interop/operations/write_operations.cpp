// write_operations FILE: writes every operation of shaders as exported C++, each with the interpreter's
// values, for tests/interop/exported.
#include <bit>

#include "io/files/output.h"
#include "io/material/shader_texts.h"
#include "tests/shader/one_operation.h"

namespace {

using namespace brdf;

std::string bits_of(const std::array<float, 3>& values) {
  std::string text;
  for (const float x : values)
    text += (text.empty() ? ", {" : ", ") + std::to_string(std::bit_cast<std::uint32_t>(x)) + "u";
  return text + "}";
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return 2;
  std::string functions, rows;
  shader::for_each_operation(
      shader::kOperandSets.size(),
      [&](shader::Op, const std::shared_ptr<const shader::ShaderReflectance>& form, const std::string& name) {
        const Material material = form->material(form);
        functions += io::shader_text(material, io::ShaderLanguage::cpp, false, name);
        rows += "    {\"" + name + "\", [](float* f) { const auto v = " + name + "::brdf_eval_" + name +
                "({0, 0, 1}, {0, 0, 1}); " + "f[0] = v.r, f[1] = v.g, f[2] = v.b; }" +
                bits_of(shader::values_in_float(material, {0, 0, 1}, {0, 0, 1})) + "},\n";
      });
  io::write_file_atomically(words[1],
                            functions +
                                "struct ExportedOperation {\n  const char* name;\n  void (*value)(float*);\n"
                                "  std::uint32_t expected[3];\n};\ninline const ExportedOperation "
                                "kExportedOperations[] = {\n" +
                                rows + "};\n");
}
