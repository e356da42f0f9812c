// The fragment shaders that evaluate a reflectance. The catalogue's are compiled with the program; those of
// one that is not in it are compiled from its GLSL when it is first drawn.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "render/vulkan/pipeline.h"

namespace brdf::render {

// Throws InputError naming the reflectance where shaders cannot have it.
void require_shader(const Reflectance& reflectance);

// Numbers of reflectances in shaders: the place in the catalogue; the others come after it.
class ReflectanceNumbers {
 public:
  void add(const Reflectance& reflectance);
  int of(const Reflectance& reflectance) const;

 private:
  std::vector<Reflectance> others_;  // never removed: pipelines are kept by their numbers
};

// SPIR-V of GLSL. Throws InputError naming whose it is, with the compiler's words.
enum class Stage { fragment, compute };
std::vector<std::uint32_t> compiled(const std::string& glsl, Stage stage, std::string_view whose);

class FragmentCode {
 public:
  // `text`: the source of what was compiled for the catalogue, without brdf.glsl.
  FragmentCode(Spirv of_catalogue, const char* text) : of_catalogue_(of_catalogue), text_(text) {}
  Spirv of(const Reflectance& reflectance, int number);

 private:
  Spirv of_catalogue_;
  const char* text_;
  std::map<int, std::vector<std::uint32_t>> others_;
};

}  // namespace brdf::render
