#include "shader/front/texts.h"

#include <algorithm>
#include <regex>
#include <set>

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

// Old spellings of what 4.50 calls otherwise, and names that a fragment shader has without declaring them.
constexpr const char* kOldWords =
    "#define varying in\n#define attribute in\n#define texture2D texture\n#define textureCube texture\n"
    "#define texture2DLod textureLod\n#define textureCubeLod textureLod\n#define gl_FragColor "
    "brdf_fragment_colour\n"
    "vec4 brdf_fragment_colour;\n";

// What snippets take from the files around them.
constexpr const char* kUsual =
    "#ifndef PI\n#define PI 3.14159265358979\n#endif\n#define M_PI 3.14159265358979\n#define INV_PI "
    "0.31830988618379\n"
    "#define M_PI_INV 0.31830988618379\n#define RECIPROCAL_PI 0.31830988618379\n#define TWO_PI "
    "6.28318530717959\n#define EPSILON 1e-6\n";

std::string usual_functions(const std::string& text) {
  std::string out = kUsual;
  std::string kept;
  // Not those that the file defines itself.
  for (std::size_t at = 0; at < out.size();) {
    const std::size_t stop = out.find('\n', at) + 1;
    const std::string line = out.substr(at, stop - at);
    std::smatch match;
    const bool define = line.starts_with("#define ");
    const std::string name = define ? line.substr(8, line.find(' ', 8) - 8) : "";
    if (define && !std::regex_search(text, std::regex("\\b" + name + "\\b\\s*(=|[0-9(])"))) kept += line;
    at = stop;
  }
  if (!std::regex_search(text, std::regex(R"((float|vec3|define)\s+saturate\b)")))
    kept += "#define saturate(x) clamp(x, 0.0, 1.0)\n";
  if (!std::regex_search(text, std::regex(R"((float|vec3|define)\s+pow2\b)")))
    kept += "#define pow2(x) ((x) * (x))\n";
  // What a page of Shadertoy gives every shader.
  for (const auto& [name, type] :
       {std::pair("iTime", "float"), std::pair("iResolution", "vec3"), std::pair("iMouse", "vec4"),
        std::pair("iFrame", "int"), std::pair("iTimeDelta", "float")})
    if (std::regex_search(text, std::regex(std::string("\\b") + name + "\\b")) &&
        !std::regex_search(text, std::regex(std::string("uniform\\s+\\w+\\s+") + name)))
      kept += std::string(type) + " " + name + ";\n";
  return kept;
}

}  // namespace

std::vector<Shadow> shadowed_builtins(const Source& source) {
  static const std::regex definition(
      R"(\b(?:void|bool|u?int|float[234]?|half[234]?|double|[biu]?vec[234]|mat[234])\s+(\w+)\s*\()");
  const std::string text = without_comments(source.text);
  std::vector<Shadow> found;
  int depth = 0;
  std::size_t counted = 0;
  std::uint32_t line = 1;
  for (std::sregex_iterator at(text.begin(), text.end(), definition), end; at != end; ++at) {
    const std::size_t place = std::size_t(at->position());
    for (; counted < place; ++counted) {
      depth += (text[counted] == '{') - (text[counted] == '}');
      line += text[counted] == '\n';
    }
    const std::string name = (*at)[1];
    if (depth == 0 && builtins().contains(name) &&
        std::none_of(found.begin(), found.end(), [&](const Shadow& s) { return s.name == name; }))
      found.push_back({name, line});
  }
  return found;
}

std::vector<Attempt> attempts(const Source& source) {
  const bool hlsl = source.language == Language::hlsl;
  std::vector<int> versions;
  std::smatch match;
  static const std::regex version(R"(#\s*version\s+(\d{3})(?!\s*es))");
  const std::string text = without_comments(source.text);
  if (!hlsl && std::regex_search(text, match, version)) {
    const int number = std::stoi(match[1]);
    if (number >= 330 && number <= 460) versions.push_back(number);
  }
  for (const int number : {450, 330})
    if (std::find(versions.begin(), versions.end(), number) == versions.end()) versions.push_back(number);
  if (hlsl) versions = {500};
  std::string renames, named;
  for (const Shadow& s : shadowed_builtins(source)) {
    renames += "#define " + s.name + " brdf_own_" + s.name + "\n";
    named += (named.empty() ? "line " : ", line ") + std::to_string(s.line) + ": " + s.name + "()";
  }
  const std::string own =
      named.empty() ? ""
                    : named + " shadows the built-in function of that name; here the file's own is called";
  const std::string base = std::string("#define main brdf_own_main\n") + (hlsl ? "" : kOldWords);
  std::vector<Attempt> out;
  for (const int v : versions) {
    if (!renames.empty()) out.push_back({v, base + renames, own});
    out.push_back({v, base, own});
  }
  const std::string usual =
      "PI, saturate() and their like, which the file does not define, are taken as usual";
  out.push_back(
      {versions[0], base + renames + usual_functions(text), own.empty() ? usual : own + "; " + usual});
  return out;
}

std::string with_entry(const Source& source) {
  if (source.language == Language::hlsl)
    return source.text + "\nfloat4 brdf_main() : SV_Target { return float4(0.0, 0.0, 0.0, 0.0); }\n";
  return source.text + "\n#undef main\nvoid main() {}\n";
}

}  // namespace brdf::shader
