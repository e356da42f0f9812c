#include "shader/front/texts.h"

#include <algorithm>
#include <regex>
#include <set>

#include "io/numbers.h"
#include "shader/front/definitions.h"
#include "shader/front/usual.h"

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

// What only Vulkan's dialect lets a layout say; blanks in its place.
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
    // A comma that is left alone, and brackets with nothing between.
    const std::size_t open = inside.find('('), last = inside.find_last_not_of(" \t\n)");
    if (last != inside.npos && inside[last] == ',') inside[last] = ' ';
    if (inside.find_first_not_of(" \t\n", open + 1) == inside.size() - 1)
      for (char& c : inside)
        if (c != '\n') c = ' ';
    out.replace(std::size_t(at->position()), inside.size(), inside);
  }
  return out;
}

}  // namespace

std::vector<Shadow> shadowed_builtins(const Source& source) {
  std::vector<Shadow> found;
  for (const Definition& d : definitions_of(without_comments(source.text)))
    if (builtins().contains(d.name) &&
        std::none_of(found.begin(), found.end(), [&](const Shadow& s) { return s.name == d.name; }))
      found.push_back({d.name, d.first_line});
  return found;
}

std::vector<Attempt> attempts(const Source& source) {
  const bool hlsl = source.language == Language::hlsl;
  std::vector<int> versions;
  std::smatch match;
  static const std::regex version(R"(#\s*version\s+(\d{3})(?!\s*es))");
  const std::string text = without_comments(source.text);
  if (!hlsl && text.find("version") != text.npos && std::regex_search(text, match, version)) {
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
  // What the file leaves to others, as usual; a file that it includes may have it.
  const Usual known = usual_of(text, source.language);
  if (!known.names.empty() && text.find("include") != text.npos)
    for (const int v : versions) out.push_back({v, base + renames, own});
  std::string note = own;
  if (!known.names.empty())
    note += (own.empty() ? "" : "; ") + io::joined(known.names) +
            (known.names.size() > 1 ? ", which the file does not define, are"
                                    : ", which the file does not define, is") +
            " taken as usual";
  for (const int v : versions) out.push_back({v, base + renames + known.preamble, note, true});
  if (!renames.empty())
    for (const int v : versions) out.push_back({v, base + known.preamble, note});
  return out;
}

std::string with_entry(const Source& source) {
  if (source.language == Language::hlsl)
    return source.text + "\nfloat4 brdf_main() : SV_Target { return float4(0.0, 0.0, 0.0, 0.0); }\n";
  return without_vulkan(source.text) + "\n#undef main\nvoid main() {}\n";
}

}  // namespace brdf::shader
