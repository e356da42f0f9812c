#include "shader/front/texts.h"

#include <algorithm>
#include <regex>
#include <set>

#include "io/files/numbers.h"
#include "io/files/text.h"
#include "shader/front/definitions.h"

namespace brdf::shader {
namespace {

const std::set<std::string>& builtins() {
  static const std::set<std::string> names{
      "radians",   "degrees",  "sin",         "cos",      "tan",         "asin",        "acos",     "atan",
      "sinh",      "cosh",     "tanh",        "asinh",    "acosh",       "atanh",       "pow",      "exp",
      "log",       "exp2",     "log2",        "sqrt",     "inversesqrt", "abs",         "sign",     "floor",
      "trunc",     "round",    "roundEven",   "ceil",     "fract",       "mod",         "modf",     "min",
      "max",       "clamp",    "mix",         "step",     "smoothstep",  "isnan",       "isinf",    "fma",
      "length",    "distance", "dot",         "cross",    "normalize",   "faceforward", "reflect",  "refract",
      "transpose", "inverse",  "determinant", "lessThan", "any",         "all",         "saturate", "lerp",
      "frac",      "rsqrt",    "noise"};
  return names;
}

// Replaces layout qualifiers that only Vulkan's dialect permits by blanks.
std::string without_vulkan(const std::string& text) {
  static const std::regex layout(R"(\blayout\s*\([^()]*\))"),
      own(R"(\b(set|constant_id|input_attachment_index)\s*=\s*\w+\s*,?)");
  std::string out = text;
  if (text.find("layout") == text.npos) return out;
  for (std::sregex_iterator at(text.begin(), text.end(), layout), end; at != end; ++at) {
    std::string inside = at->str();
    for (std::smatch match; std::regex_search(inside, match, own);)
      inside.replace(std::size_t(match.position()), std::size_t(match.length()), std::size_t(match.length()),
                     ' ');
    if (const std::size_t place = inside.find("push_constant"); place != inside.npos)
      inside.replace(place, 13, "std140       ");
    // Removes a comma at the end, and a layout without any qualifier.
    const std::size_t open = inside.find('('), last = inside.find_last_not_of(" \t\n)");
    if (last != inside.npos && inside[last] == ',') inside[last] = ' ';
    if (inside.find_first_not_of(" \t\n", open + 1) == inside.size() - 1)
      for (char& c : inside)
        if (c != '\n') c = ' ';
    out.replace(std::size_t(at->position()), inside.size(), inside);
  }
  return out;
}

// --- Definitions that snippets expect from the surrounding files ------------------------------------------
// Constants and one-line functions that are written alike everywhere.

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

// half, half3 or half3x3.
bool is_half(std::string_view word) {
  return word.starts_with("half") && word.find_first_not_of("1234x", 4) == word.npos;
}

// The compiler takes half for float. Returns definitions that make it a type that may have 16 bits.
std::string narrow_types(const std::string& whole, Language language) {
  std::set<std::string> names;
  if (language == Language::hlsl)
    for (const Token& token : tokens_of(whole))
      if (is_half(token.text)) names.emplace(token.text);
  std::string out;
  for (const std::string& name : names) out += "#define " + name + " min16float" + name.substr(4) + "\n";
  return out;
}

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

struct Usual {
  std::string preamble;            // their definitions
  std::vector<std::string> names;  // in the order of the list, without the words of older GLSL
};

// Returns the definitions that the text uses but does not contain, in its language. `whole`: the text after
// the preprocessor, with all includes, so that a macro or a constant that an included file defines is not
// defined again.
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

}  // namespace

std::string narrow_word(const std::string& whole, Language language) {
  for (const Token& token : tokens_of(whole)) {
    const bool is = language == Language::hlsl ? is_half(token.text) || token.text.starts_with("min16float")
                                               : token.is("mediump") || token.is("lowp");
    if (is) return std::string(token.text);
  }
  return "";
}

std::vector<Shadow> shadowed_builtins(const Files& files) {
  std::vector<Shadow> found;
  for (const auto& [path, file] : files.all())
    for (const Definition& d : definitions_of(file.bare))
      if (builtins().contains(d.name) &&
          std::ranges::none_of(found, [&](const Shadow& s) { return s.name == d.name; }))
        found.push_back({d.name, path.empty() ? "" : file.shown, d.first_line});
  return found;
}

std::string common_preamble(const Source& source) {
  std::string out =
      source.language == Language::hlsl ? "" : "#extension GL_GOOGLE_include_directive : enable\n";
  for (const std::string& define : source.defines) {
    const std::size_t equals = define.find('=');
    out += "#define " + define.substr(0, equals) + " " +
           (equals == define.npos ? "1" : define.substr(equals + 1)) + "\n";
  }
  return out + "#define main brdf_own_main\n";
}

std::vector<int> versions_of(const Source& source) {
  if (source.language == Language::hlsl) return {500};
  std::vector<int> versions;
  const std::vector<Token> tokens = tokens_of(source.bare, true);
  for (std::size_t k = 0; k + 2 < tokens.size(); ++k) {
    if (!tokens[k].is("#") || !tokens[k + 1].is("version") ||
        (k + 3 < tokens.size() && tokens[k + 3].is("es")))
      continue;
    double number = 0;
    if (io::parse_number(tokens[k + 2].text, number) && number >= 330 && number <= 460)
      versions.push_back(int(number));
    break;
  }
  for (const int number : {450, 330})
    if (std::ranges::find(versions, number) == versions.end()) versions.push_back(number);
  return versions;
}

std::vector<Attempt> attempts(const Files& files, const Source& source, const std::string& whole) {
  const std::vector<int> versions = versions_of(source);
  std::string renames, named;
  for (const Shadow& s : shadowed_builtins(files)) {
    renames += "#define " + s.name + " brdf_own_" + s.name + "\n";
    named += std::string(named.empty() ? "" : ", ") + (s.file.empty() ? "line " : s.file + ":") +
             std::to_string(s.line) + ": " + s.name + "()";
  }
  std::string note =
      named.empty()
          ? ""
          : named + " shadows the built-in function of the same name; the function of the file is used";
  const std::string base = common_preamble(source);
  const Usual known = usual_of(whole, source.language);
  if (!known.names.empty())
    note += (note.empty() ? "" : "; ") + io::joined(known.names) +
            (known.names.size() > 1 ? ", which the file does not define, are"
                                    : ", which the file does not define, is") +
            " given the usual definition";
  std::vector<Attempt> out;
  const std::string narrow = narrow_word(whole, source.language);
  if (!narrow.empty())
    for (const int v : versions)
      out.push_back(
          {v, base + narrow_types(whole, source.language) + renames + known.preamble, note, false, true});
  for (const int v : versions) out.push_back({v, base + renames + known.preamble, note});
  if (!renames.empty())
    for (const int v : versions) out.push_back({v, base + known.preamble, note, true});
  return out;
}

std::string with_entry(const std::string& text, Language language) {
  if (language == Language::hlsl)
    return text + "\nfloat4 brdf_main() : SV_Target { return float4(0.0, 0.0, 0.0, 0.0); }\n";
  // The body is not empty, so that the initialisers of globals can be moved into it.
  return without_vulkan(text) + "\n#undef main\nvoid main() { float brdf_nothing = 0.0; }\n";
}

}  // namespace brdf::shader
