#include "io/material/shader_texts.h"

#include "io/files/identifier.h"
#include "io/files/text.h"
#include "io/material/glsl.h"
#include "io/material/shader_language.h"
#include "io/material/shader_words.h"

namespace brdf::io {
namespace {

std::string hlsl(std::string text) {
  replace_all(text, "vec3(0.0)", "vec3(0.0, 0.0, 0.0)");
  return with_words(text, [](std::string word) -> std::string {
    if (word == "vec3") return "float3";
    if (word == "floatBitsToUint") return "asuint";
    if (word == "uintBitsToFloat") return "asfloat";
    return word;
  });
}

// Returns the line of a slider: type, name and range.
std::string slider(const ParameterInfo& p, const std::string& name, bool weight,
                   const std::vector<double>& of_channels) {
  if (!weight)
    return "float " + name + " " + to_text(usual_min(p)) + " " + to_text(p.usual_max) + " " +
           to_text(of_channels[0]) + "\n";
  std::string line = "color " + name;
  for (std::size_t c = 0; c < 3; ++c) line += " " + to_text(of_channels[of_channels.size() == 1 ? 0 : c]);
  return line + "\n";
}

std::string explorer(const Material& material, const std::string& functions, bool with_material) {
  std::string sliders, call = "brdf_material(wi, wo)";
  if (!with_material) {
    const Term& term = material.terms[0];
    const ReflectanceInfo& form = info(term.form);
    call = "brdf_eval_" + std::string(form.name) + "(wi, wo";
    const std::vector<std::string> names = argument_names(form.shape, form.weights);
    const auto add = [&](const ParameterInfo& p, std::size_t k, bool weight,
                         const std::vector<std::vector<double>>& sets) {
      std::vector<double> values;
      for (const std::vector<double>& set : sets) values.push_back(set[k]);
      const std::string& name = names[weight ? form.shape.size() + k : k];
      sliders += slider(p, name, weight, values);
      call += ", " + name;
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

// --- C++ ---------------------------------------------------------------------------------------------------

// Fast mathematics breaks (x + 12582912) - 12582912 and compensated products. clang has no macro for the
// individual options (-funsafe-math-optimizations), g++ 12 has macros. In older versions of g++ the header
// sets function options instead; this prevents inlining and halves the speed, so newer versions do not use
// them. Contraction only changes the rounding and is harmless.
constexpr const char* kBegin = R"text(#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)
#error "brdf: the values are wrong with -ffast-math, -Ofast, -funsafe-math-optimizations, -fassociative-math and /fp:fast: compile without these options, or include this header in a separate file"
#endif
#if defined(__clang__)
#define BRDF_AS_WRITTEN _Pragma("clang fp reassociate(off) contract(off)")
#else
#define BRDF_AS_WRITTEN
#endif
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 12
#pragma GCC push_options
#pragma GCC optimize("no-associative-math")
#endif
)text";

constexpr const char* kEnd = R"(#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 12
#pragma GCC pop_options
#endif
#undef BRDF_AS_WRITTEN
)";

constexpr const char* kTypes = R"(using uint = std::uint32_t;
struct vec3 {
  union { float x, r; };
  union { float y, g; };
  union { float z, b; };
  vec3(float first, float second, float third) : x(first), y(second), z(third) {}
  explicit vec3(float all) : vec3(all, all, all) {}
  vec3& operator+=(const vec3& v) { x += v.x; y += v.y; z += v.z; return *this; }
};
inline vec3 operator+(const vec3& a, const vec3& b) { return vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
inline vec3 operator*(const vec3& v, float s) { return vec3(v.x * s, v.y * s, v.z * s); }
inline vec3 operator/(const vec3& v, float s) { return vec3(v.x / s, v.y / s, v.z / s); }
inline float dot(const vec3& a, const vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float clamp(float x, float least, float most) { return most < x ? most : x < least ? least : x; }
inline uint floatBitsToUint(float x) { uint bits; std::memcpy(&bits, &x, 4); return bits; }
inline float uintBitsToFloat(uint bits) { float x; std::memcpy(&x, &bits, 4); return x; }
)";

// Names from the namespace that the headers share. They are imported one by one, because a using-directive
// would make them ambiguous if the user has a vec3 of their own.
constexpr std::string_view kShared[]{
    "uint",     "vec3",     "clamp",      "floatBitsToUint", "uintBitsToFloat",
    "brdf_exp", "brdf_log", "brdf_log1p", "brdf_erfcx",      "brdf_angle"};

// Converts functions to C++: they become inline, keep their arithmetic unchanged, and use float literals.
std::string as_cpp(const std::string& text) {
  const std::string plain = with_words(text, [](std::string word) -> std::string {
    if (word == "precise") return "const";
    if (word == "exp" || word == "log" || word == "sqrt") return "std::" + word;
    const bool number = std::isdigit(static_cast<unsigned char>(word[0]));
    return number && word.find_first_of(".e") != word.npos ? word + "f" : word;
  });
  std::string out;
  for (std::size_t k = 0; k < plain.size();) {
    const std::size_t end = plain.find('\n', k) + 1;
    const std::string line = plain.substr(k, end - k);
    const bool begins = line.starts_with("float ") || line.starts_with("vec3 ");
    out += begins ? "inline " + line + "  BRDF_AS_WRITTEN\n" : line;
    k = end;
  }
  return out;
}

// Returns a header that computes the library's float values. With the library's kernels the values are
// bit-identical if contraction is off (-ffp-contract=off). The header refuses -ffast-math and similar
// options if a macro reveals them; otherwise the header itself disables reassociation. The namespace `name`
// (io/files/identifier.h) holds the functions of the forms, and brdf_material(wi, wo) if `with_material`.
// vec3 and the kernels are in a namespace that several headers share. `builtin_kernels`: use the standard
// functions instead of the library's kernels.
std::string cpp_text(const Material& material, bool with_material, const std::string& given,
                     bool builtin_kernels) {
  const GlslParts parts = glsl_parts(material, {.material = with_material,
                                                .whole = false,
                                                .builtin_kernels = builtin_kernels,
                                                .translated = ShaderLanguage::cpp});
  const std::string kernels = kTypes + as_cpp(parts.kernels), number = text_number(kernels),
                    shared = "brdf_kernels_" + number, name = identifier(given, NameIn::cpp);
  std::string functions;
  for (const std::string_view word : kShared)
    functions += "using " + shared + "::" + std::string(word) + ";\n";
  for (const auto& [form, text] : parts.forms) functions += as_cpp(text);
  functions += as_cpp(parts.material);
  // The namespace contains a number of the text. Otherwise, if two files of a program have materials of the
  // same name, the linker would use either of them for both.
  const std::string own = "text_" + text_number(functions);
  return parts.head + kBegin +
         guarded("BRDF_KERNELS_" + number,
                 "namespace " + shared + " {\n" + kernels + "}  // namespace " + shared + "\n", "") +
         guarded("BRDF_MATERIAL_" + name,
                 "namespace " + name + " {\ninline namespace " + own + " {\n" + functions +
                     "}  // namespace " + own + "\n}  // namespace " + name + "\n",
                 "two materials have the name " + name + " in one file: export one of them with --name") +
         kEnd;
}

}  // namespace

std::string shader_text(const Material& material, ShaderLanguage language, bool with_material,
                        const std::string& name, bool builtin_kernels) {
  GlslContent content{.material = with_material,
                      .whole = false,
                      .dialect = language == ShaderLanguage::glsl_es ? GlslDialect::es : GlslDialect::vulkan,
                      .builtin_kernels = builtin_kernels,
                      .translated = language};
  switch (language) {
    case ShaderLanguage::glsl:
    case ShaderLanguage::glsl_es:
      return glsl_source(material, content);
    case ShaderLanguage::hlsl:
      content.name = name;
      content.guarded = true;
      return hlsl(glsl_source(material, content));
    case ShaderLanguage::cpp:
      return cpp_text(material, with_material, name, builtin_kernels);
    case ShaderLanguage::explorer:
      return explorer(material, glsl_source(material, content), with_material);
  }
  return {};
}

}  // namespace brdf::io
