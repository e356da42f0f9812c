#include "shader/front/usual.h"

#include <set>
#include <string_view>

#include "shader/front/definitions.h"

namespace brdf::shader {
namespace {

enum class Of { both, glsl, hlsl };

struct Known {
  const char *name, *rest;  // "#define NAME" and the text that follows
  Of of = Of::both;
};

constexpr Known kKnown[] = {
    {"PI", " 3.14159265358979"},
    {"M_PI", " 3.14159265358979"},
    {"UNITY_PI", " 3.14159265358979"},
    {"INV_PI", " 0.31830988618379"},
    {"M_PI_INV", " 0.31830988618379"},
    {"M_1_PI", " 0.31830988618379"},
    {"ONE_OVER_PI", " 0.31830988618379"},
    {"RECIPROCAL_PI", " 0.31830988618379"},
    {"UNITY_INV_PI", " 0.31830988618379"},
    {"TWO_PI", " 6.28318530717959"},
    {"PI2", " 6.28318530717959"},
    {"HALF_PI", " 1.57079632679490"},
    {"EPSILON", " 1e-6"},
    {"FLT_EPSILON", " 1.1920929e-7"},
    {"M_FLOAT_EPS", " 1e-8"},
    {"HALF_MIN", " 6.103515625e-5"},
    {"saturate", "(x) clamp(x, 0.0, 1.0)", Of::glsl},
    {"saturateMediump", "(x) min(x, 65504.0)"},
    {"lerp", "(a, b, t) mix(a, b, t)", Of::glsl},
    {"rcp", "(x) (1.0 / (x))", Of::glsl},
    {"sq", "(x) ((x) * (x))"},
    {"sqr", "(x) ((x) * (x))"},
    {"square", "(x) ((x) * (x))"},
    {"Square", "(x) ((x) * (x))"},
    {"pow2", "(x) ((x) * (x))"},
    {"Pow2", "(x) ((x) * (x))"},
    {"pow3", "(x) ((x) * (x) * (x))"},
    {"pow4", "(x) ((x) * (x) * ((x) * (x)))"},
    {"Pow4", "(x) ((x) * (x) * ((x) * (x)))"},
    {"pow5", "(x) ((x) * (x) * ((x) * (x)) * (x))"},
    {"Pow5", "(x) ((x) * (x) * ((x) * (x)) * (x))"},
    {"transposeMat3", "(m) transpose(m)", Of::glsl},
    {"SafeNormalize", "(v) normalize(v)"},
    {"SmoothnessToPerceptualRoughness", "(s) (1.0 - (s))"},
    {"PerceptualRoughnessToRoughness", "(r) ((r) * (r))"},
    {"DotClamped", "(a, b) saturate(dot(a, b))", Of::hlsl},
};

// Variables that a Shadertoy page provides to every shader.
constexpr Known kOfThePage[] = {{"iTime", "float", Of::glsl},
                                {"iResolution", "vec3", Of::glsl},
                                {"iMouse", "vec4", Of::glsl},
                                {"iFrame", "int", Of::glsl},
                                {"iTimeDelta", "float", Of::glsl}};

// Spellings of older GLSL, and names that a fragment shader may use without a declaration.
constexpr Known kOldWords[] = {
    {"varying", " in", Of::glsl},
    {"attribute", " in", Of::glsl},
    {"texture2D", " texture", Of::glsl},
    {"textureCube", " texture", Of::glsl},
    {"texture2DLod", " textureLod", Of::glsl},
    {"textureCubeLod", " textureLod", Of::glsl},
    {"gl_FragColor", " brdf_fragment_colour\nvec4 brdf_fragment_colour;", Of::glsl}};

// The words of the text, and the words that it defines: constants, variables and functions. A defined word
// follows a type or precedes an assigned value.
struct Words {
  std::set<std::string_view> used = {}, defined = {};
};

Words words_of(const std::string& text) {
  Words out;
  const std::vector<Token> tokens = tokens_of(text);
  const auto is = [&](std::size_t k, std::string_view word) {
    return k < tokens.size() && tokens[k].is(word);
  };
  const auto types = [&](std::size_t k) {  // may be the type in front of a declared name
    return is_word(tokens[k].text[0]) && !tokens[k].is("return") && !tokens[k].is("case") &&
           !tokens[k].is("else");
  };
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    if (!is_word(tokens[k].text[0])) continue;
    out.used.insert(tokens[k].text);
    if ((k > 0 && types(k - 1)) || (is(k + 1, "=") && !is(k + 2, "="))) out.defined.insert(tokens[k].text);
  }
  return out;
}

}  // namespace

Usual usual_of(const std::string& whole, Language language) {
  Usual out;
  const Words words = words_of(whole);
  const auto wanted = [&](const Known& k) {
    const bool other = k.of == (language == Language::hlsl ? Of::glsl : Of::hlsl);
    return !other && words.used.contains(k.name) && !words.defined.contains(k.name);
  };
  for (const Known& k : kKnown) {
    if (!wanted(k)) continue;
    out.preamble += std::string("#define ") + k.name + k.rest + "\n";
    out.names.push_back(k.name);
  }
  for (const Known& k : kOldWords)
    if (wanted(k)) out.preamble += std::string("#define ") + k.name + k.rest + "\n";
  for (const Known& k : kOfThePage)
    if (wanted(k)) out.preamble += std::string(k.rest) + " " + k.name + ";\n";
  return out;
}

}  // namespace brdf::shader
