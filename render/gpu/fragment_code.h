// The fragment shaders that evaluate a reflectance. Shaders of the catalogue are compiled with the program.
// The shader of any other reflectance is compiled from its GLSL when the reflectance is first drawn.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "render/vulkan/pipeline.h"

namespace brdf::render {

// Throws InputError naming the reflectance if shaders cannot evaluate it.
void require_shader(const Reflectance& reflectance);

// Numbers of reflectances in shaders: the index in the catalogue; other reflectances follow after the
// catalogue.
class ReflectanceNumbers {
 public:
  void add(const Reflectance& reflectance);
  int of(const Reflectance& reflectance) const;

 private:
  // Entries are never removed because pipelines are stored by these numbers.
  std::vector<Reflectance> others_;
};

// Compiles GLSL to SPIR-V. Throws InputError with `whose` and the compiler's message.
enum class Stage { fragment, compute };
std::vector<std::uint32_t> compiled(const std::string& glsl, Stage stage, std::string_view whose);

class FragmentCode {
 public:
  // `text`: the source of the shader that was compiled for the catalogue, without brdf.glsl.
  FragmentCode(Spirv of_catalogue, const char* text) : of_catalogue_(of_catalogue), text_(text) {}
  Spirv of(const Reflectance& reflectance, int number);

 private:
  Spirv of_catalogue_;
  const char* text_;
  std::map<int, std::vector<std::uint32_t>> others_;
};

}  // namespace brdf::render
