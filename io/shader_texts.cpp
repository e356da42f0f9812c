#include "io/shader_texts.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "io/glsl.h"
#include "io/identifier.h"
#include "io/text.h"

namespace brdf::io {
namespace {

bool in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
}

// Every word outside of comments as `change` has it; numbers and members (f.r) count as words.
template <class Change>
std::string with_words(const std::string& text, Change&& change) {
  std::string out;
  for (std::size_t k = 0; k < text.size();) {
    std::size_t end = k;
    if (text.compare(k, 2, "//") == 0) {
      end = std::min(text.find('\n', k), text.size());
      out += text.substr(k, end - k);
    } else if (in_word(text[k])) {
      while (end < text.size() &&
             (in_word(text[end]) || ((text[end] == '-' || text[end] == '+') && text[end - 1] == 'e' &&
                                     std::isdigit(static_cast<unsigned char>(text[k])))))
        ++end;
      out += change(text.substr(k, end - k));
    } else {
      out += text[end++];
    }
    k = end;
  }
  return out;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
    text.replace(at, what.size(), by);
}

std::string hlsl(std::string text) {
  replace_all(text, "vec3(0.0)", "vec3(0.0, 0.0, 0.0)");
  return with_words(text, [](std::string word) -> std::string {
    if (word == "vec3") return "float3";
    if (word == "floatBitsToUint") return "asuint";
    if (word == "uintBitsToFloat") return "asfloat";
    return word;
  });
}

constexpr const char* kCppBegin = R"(#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>

namespace NAME {
using uint = std::uint32_t;
using std::sqrt;
struct vec3 {
  union { float x, r; };
  union { float y, g; };
  union { float z, b; };
  vec3(float first, float second, float third) : x(first), y(second), z(third) {}
  explicit vec3(float all) : vec3(all, all, all) {}
  vec3& operator+=(const vec3& v) { x += v.x; y += v.y; z += v.z; return *this; }
};
inline uint floatBitsToUint(float x) { uint bits; std::memcpy(&bits, &x, 4); return bits; }
inline float uintBitsToFloat(uint bits) { float x; std::memcpy(&x, &bits, 4); return x; }
)";

// Functions become inline, numbers float's.
std::string cpp(const std::string& text, const std::string& name) {
  const std::string plain = with_words(text, [](std::string word) -> std::string {
    if (word == "precise") return "const";
    const bool number = std::isdigit(static_cast<unsigned char>(word[0]));
    return number && word.find_first_of(".e") != word.npos ? word + "f" : word;
  });
  std::string out;
  for (std::size_t k = 0; k < plain.size();) {
    const std::size_t end = plain.find('\n', k) + 1;
    const std::string line = plain.substr(k, end - k);
    out += line.starts_with("float ") || line.starts_with("vec3 ") ? "inline " + line : line;
    k = end;
  }
  std::string begin = kCppBegin;
  replace_all(begin, "NAME", name);
  return begin + out + "}  // namespace " + name + "\n";
}

// A slider's line: its type, name and range.
std::string slider(const ParameterInfo& p, bool weight, const std::vector<double>& of_channels) {
  if (!weight)
    return "float " + std::string(p.name) + " " + to_text(p.min) + " " + to_text(p.usual_max) + " " +
           to_text(of_channels[0]) + "\n";
  std::string line = "color " + std::string(p.name);
  for (std::size_t c = 0; c < 3; ++c) line += " " + to_text(of_channels[of_channels.size() == 1 ? 0 : c]);
  return line + "\n";
}

std::string explorer(const Material& material, const std::string& functions, bool with_material) {
  std::string sliders, call = "brdf_material(wi, wo)";
  if (!with_material) {
    const Term& term = material.terms[0];
    const ReflectanceInfo& form = info(term.form);
    call = "brdf_eval_" + std::string(form.name) + "(wi, wo";
    const auto add = [&](const ParameterInfo& p, std::size_t k, bool weight,
                         const std::vector<std::vector<double>>& sets) {
      std::vector<double> values;
      for (const std::vector<double>& set : sets) values.push_back(set[k]);
      sliders += slider(p, weight, values);
      call += ", " + std::string(p.name);
    };
    for (std::size_t k = 0; k < form.shape.size(); ++k) add(form.shape[k], k, false, term.shape);
    for (std::size_t k = 0; k < form.weights.size(); ++k) add(form.weights[k], k, true, term.weights);
    call += ")";
  }
  return "analytic\n::begin parameters\n" + sliders + "::end parameters\n::begin shader\n" + functions +
         "vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n"
         "  vec3 wi = vec3(dot(L, X), dot(L, Y), dot(L, N)), wo = vec3(dot(V, X), dot(V, Y), dot(V, N));\n"
         "  return " +
         call + ";\n}\n::end shader\n";
}

}  // namespace

std::string shader_text(const Material& material, ShaderLanguage language, bool with_material,
                        const std::string& name, bool builtin_kernels) {
  const std::string glsl =
      glsl_source(material, {.material = with_material, .whole = false, .builtin_kernels = builtin_kernels});
  switch (language) {
    case ShaderLanguage::hlsl:
      return hlsl(glsl);
    case ShaderLanguage::cpp:
      return cpp(glsl, identifier(name));
    case ShaderLanguage::explorer:
      return explorer(material, glsl, with_material);
  }
  return {};
}

}  // namespace brdf::io
