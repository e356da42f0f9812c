#include "shader/front/texts.h"

#include <algorithm>
#include <regex>
#include <set>

#include "io/files/numbers.h"
#include "io/files/text.h"
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

}  // namespace

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
      named.empty() ? ""
                    : named + " shadows the built-in function of that name; here the file's own is called";
  const std::string base = common_preamble(source);
  const Usual known = usual_of(whole, source.language);
  if (!known.names.empty())
    note += (note.empty() ? "" : "; ") + io::joined(known.names) +
            (known.names.size() > 1 ? ", which the file does not define, are"
                                    : ", which the file does not define, is") +
            " taken as usual";
  std::vector<Attempt> out;
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
