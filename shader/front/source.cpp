#include "shader/front/source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/content.h"
#include "io/error.h"
#include "io/text.h"

namespace brdf::shader {
namespace {

constexpr int kDeepest = 100;                // brackets within brackets
constexpr std::size_t kLongestChain = 2000;  // operators without a semicolon or a bracket between

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c >= '0' && c <= '9');
}

// What would exhaust a compiler's stack.
void check_depth(const std::string& name, const std::string& text) {
  int depth = 0;
  std::size_t chain = 0, at = 0;
  for (const char c : text) {
    ++at;
    depth += c == '(' || c == '[' || c == '{';
    depth -= c == ')' || c == ']' || c == '}';
    chain = c == ';' || c == '{' || c == '}' || c == ','
                ? 0
                : chain + (std::string_view("+-*/%&|^!~<>=?:").find(c) != std::string_view::npos);
    if (depth > kDeepest || chain > kLongestChain)
      throw InputError(name + ":" + std::to_string(io::line_of(text, at - 1)) +
                       ": is nested too deeply to be a reflectance");
  }
}

double number_of(std::string_view word, const std::string& where) {
  double value;
  if (!io::parse_number(word, value) || !std::isfinite(value))
    throw InputError(where + io::shown(word) + " is not a finite number");
  return value;
}

std::optional<Role> role_of(std::string_view word) {
  return find_named<Role>(std::string(word));
}

// Words after a parameter's name: numbers, then "log" and "role ROLE".
struct Words {
  std::vector<double> numbers;
  bool log_scale = false;
  Role role = Role::other;
};
Words read_words(std::span<const std::string_view> words, const std::string& where) {
  Words out;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] == "log") {
      out.log_scale = true;
    } else if (words[k] == "role") {
      const auto role = k + 1 < words.size() ? role_of(words[k + 1]) : std::nullopt;
      if (!role) throw InputError(where + "role must be one of " + known_names<Role>());
      out.role = *role;
      ++k;
    } else {
      out.numbers.push_back(number_of(words[k], where));
    }
  }
  return out;
}

void check(const Declared& p, const std::string& where) {
  if (p.min && p.max && !(*p.min <= *p.max))
    throw InputError(where + p.name + ": its least value is above its largest");
  for (const double value : p.initial)
    if ((p.min && value < *p.min) || (p.max && value > *p.max))
      throw InputError(where + p.name + ": its default is out of its range");
  if (p.log_scale && p.max && !(*p.max > 0))
    throw InputError(where + p.name + ": a log scale needs values above 0");
}

// "param NAME MIN MAX DEFAULT [log] [role R]", "bool NAME 0|1", "color NAME r g b", the last two also as
// "param NAME bool 0|1" and "param NAME color r g b", and BRDF Explorer's "float NAME MIN MAX DEFAULT".
Declared read_declared(std::string_view kind, std::span<const std::string_view> words, std::uint32_t line,
                       const std::string& where) {
  if (words.empty()) throw InputError(where + "the parameter's name is missing");
  if (kind == "param" && words.size() > 1 && (words[1] == "color" || words[1] == "bool")) {
    std::vector<std::string_view> rest(words.begin(), words.end());
    rest.erase(rest.begin() + 1);
    return read_declared(words[1], rest, line, where);
  }
  const Words w = read_words(words.subspan(1), where);
  Declared p{std::string(words[0])};
  p.line = line;
  p.log_scale = w.log_scale;
  p.role = w.role;
  const std::size_t count = w.numbers.size();
  if (kind == "bool") {
    if (count > 1) throw InputError(where + "a bool has one default, 0 or 1");
    p.min = 0, p.max = 1;
    p.initial = {count == 1 && w.numbers[0] != 0 ? 1.0 : 0.0};
  } else if (kind == "color") {
    if (count != 3 && count != 1) throw InputError(where + "a color has three numbers");
    p.min = 0, p.max = std::max(1.0, *std::max_element(w.numbers.begin(), w.numbers.end()));
    p.initial = w.numbers;
  } else {
    if (count != 2 && count != 3) throw InputError(where + "must be NAME MIN MAX DEFAULT [log]");
    p.min = w.numbers[0], p.max = w.numbers[1];
    if (count == 3) p.initial = {w.numbers[2]};
  }
  check(p, where);
  return p;
}

// "CHECK STATEMENT" or "CHECK at THETA STATEMENT".
KnownViolation read_violation(std::span<const std::string_view> words, std::uint32_t line,
                              const std::string& where) {
  if (words.empty()) throw InputError(where + "violates what? The name of a check, as energy or reciprocity");
  KnownViolation v{std::string(words[0]), "", 0, line};
  words = words.subspan(1);
  if (words.size() > 1 && words[0] == "at") {
    v.theta = number_of(words[1], where);
    words = words.subspan(2);
  }
  for (const std::string_view word : words)
    v.statement += (v.statement.empty() ? "" : " ") + std::string(word);
  return v;
}

// A line that begins with //: says something to this program.
void read_note(Source& source, std::string_view line, std::uint32_t number) {
  const std::string where = source.name + ":" + std::to_string(number) + ": ";
  std::vector<std::string_view> words;
  io::split_blanks(io::trimmed(line), words);
  if (words.empty()) return;
  const std::string rest(io::trimmed(io::trimmed(line).substr(words[0].size())));
  if (words[0] == "param" || words[0] == "bool" || words[0] == "color")
    source.parameters.push_back(
        read_declared(words[0], std::span<const std::string_view>(words).subspan(1), number, where));
  else if (words[0] == "entry")
    source.entry = parse_entry(rest);
  else if (words[0] == "returns")
    source.returns = parse_returns(rest);
  else if (words[0] == "violates")
    source.violations.push_back(
        read_violation(std::span<const std::string_view>(words).subspan(1), number, where));
  else
    throw InputError(where + "//: " + std::string(words[0]) +
                     ": must be param, bool, color, entry, returns or violates");
}

// BRDF Explorer's file becomes GLSL: its parameters are globals, in the lines where they stood; other lines are empty. What its
// `//:` lines say besides comes last, and wins.
void read_explorer(Source& source) {
  source.explorer = true;
  const std::vector<Declared> noted = std::exchange(source.parameters, {});
  std::string glsl, block;
  bool has_shader = false;
  std::uint32_t number = 0;
  std::size_t at = 0;
  std::vector<std::string_view> words;
  while (at < source.text.size()) {
    const std::size_t stop = std::min(source.text.find('\n', at), source.text.size());
    const std::string_view line(source.text.data() + at, stop - at);
    at = stop + 1;
    ++number;
    io::split_blanks(io::trimmed(line), words);
    const std::string where = source.name + ":" + std::to_string(number) + ": ";
    if (!words.empty() && words[0] == "::begin") {
      if (words.size() < 2) throw InputError(where + "::begin what?");
      block = words[1];
      has_shader = has_shader || block == "shader";
    } else if (!words.empty() && words[0] == "::end") {
      block.clear();
    } else if (block == "shader") {
      glsl += line;
    } else if (block == "parameters" && !words.empty() && !words[0].starts_with("#") &&
               !words[0].starts_with("//")) {
      if (words[0] != "float" && words[0] != "bool" && words[0] != "color")
        throw InputError(where + "a parameter is a float, a bool or a color");
      std::span<const std::string_view> rest = std::span<const std::string_view>(words).subspan(1);
      for (std::size_t k = 0; k < rest.size(); ++k)
        if (rest[k].starts_with("#") || rest[k].starts_with("//")) rest = rest.first(k);
      source.parameters.push_back(read_declared(words[0], rest, number, where));
      const std::string& name = source.parameters.back().name;
      if (!std::all_of(name.begin(), name.end(), is_letter))
        throw InputError(where + io::shown(name) + " is no name");
      source.globals.push_back(name);
      glsl += (words[0] == "color" ? "vec3 " : std::string(words[0]) + " ") + name + ";";
    }
    glsl += '\n';
  }
  if (!has_shader)
    throw InputError(source.name +
                     ": has no ::begin shader; a .brdf file has its function BRDF(L, V, N, X, Y) there");
  source.parameters.insert(source.parameters.end(), noted.begin(), noted.end());
  source.text = std::move(glsl);
  if (!source.entry) source.entry = EntryLine{"BRDF"};
}

bool begins_a_block(std::string_view text) {
  return text.starts_with("::begin") || text.find("\n::begin") != std::string_view::npos;
}

// Whether the word stands there alone.
bool has_word(const std::string& text, std::string_view word) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
    if ((at == 0 || !is_letter(text[at - 1])) &&
        (at + word.size() == text.size() || !is_letter(text[at + word.size()])))
      return true;
  return false;
}

// Blanks in place of all characters outside the parts; lines stay.
void keep_parts(std::string& text, const std::vector<std::pair<std::size_t, std::size_t>>& parts) {
  std::size_t at = 0;
  const auto blank_to = [&](std::size_t stop) {
    for (; at < stop && at < text.size(); ++at)
      if (text[at] != '\n') text[at] = ' ';
  };
  for (const auto& [begin, end] : parts) blank_to(begin), at = std::max(at, end);
  blank_to(text.size());
}

// What stands within a script's backticks, or within CGPROGRAM and ENDCG; of a text that has neither all.
void keep_shaders(std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> parts;
  if (has_word(text, "export") || has_word(text, "const") || has_word(text, "glsl"))
    for (std::size_t open = text.find('`'); open != text.npos;) {
      const std::size_t close = text.find('`', open + 1);
      if (close == text.npos) break;
      parts.emplace_back(open + 1, close);
      open = text.find('`', close + 1);
    }
  for (const auto& [begin, end] : {std::pair("HLSLPROGRAM", "ENDHLSL"), std::pair("HLSLINCLUDE", "ENDHLSL"),
                                   std::pair("CGPROGRAM", "ENDCG"), std::pair("CGINCLUDE", "ENDCG")})
    for (std::size_t open = text.find(begin); open != text.npos; open = text.find(begin, open + 1)) {
      const std::size_t first = open + std::string_view(begin).size(), close = text.find(end, first);
      if (close != text.npos) parts.emplace_back(first, close);
    }
  std::sort(parts.begin(), parts.end());
  if (!parts.empty()) keep_parts(text, parts);
}

// Languages that look like a shader's and are none of those read.
void check_language(const std::string& name, const std::string& text) {
  const auto has = [&](std::string_view part) { return text.find(part) != text.npos; };
  const auto refuse = [&](const std::string& language) {
    throw InputError(
        name + ": is " + language +
        ", which is not read: write the function in GLSL or HLSL, as `vec3 brdf(vec3 L, vec3 V, vec3 N, "
        "float roughness) { ... }`");
  };
  if (has("-> vec3<f") || has("-> vec3f") || has(": vec3<f") || has(": vec3f")) refuse("WGSL");
  if (has("metal_stdlib") || has("using namespace metal")) refuse("Metal's language");
  if (has("closure color")) refuse("Open Shading Language");
  if (has_word(text, "shader_type")) refuse("Godot's language");
  if (has("glm::vec") || has("__device__") || has_word(text, "__kernel") || has("std::"))
    refuse("C++ or a dialect of it");
}

// By the words of one language alone, else by the file's suffix: engines call both kinds .fx, .shader or .txt.
Language language_of(const std::string& text, const std::string& suffix) {
  const auto any = [&](std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return has_word(text, w); });
  };
  const bool glsl = any({"vec2", "vec3", "vec4"}),
             hlsl = any({"float2", "float3", "float4", "half3", "half4", "cbuffer", "min16float3"});
  if (glsl != hlsl) return hlsl ? Language::hlsl : Language::glsl;
  const bool by_suffix = suffix == ".hlsl" || suffix == ".hlsli" || suffix == ".fx" || suffix == ".fxh" ||
                         suffix == ".usf" || suffix == ".ush" || suffix == ".cginc";
  return by_suffix ? Language::hlsl : Language::glsl;
}

}  // namespace

std::string without_comments(std::string_view text) {
  std::string out(text);
  for (std::size_t k = 0; k < out.size();) {
    if (out.compare(k, 2, "//") == 0) {
      while (k < out.size() && out[k] != '\n') out[k++] = ' ';
    } else if (out.compare(k, 2, "/*") == 0) {
      const std::size_t stop = out.find("*/", k + 2);
      for (const std::size_t end = stop == out.npos ? out.size() : stop + 2; k < end; ++k)
        if (out[k] != '\n') out[k] = ' ';
    } else {
      ++k;
    }
  }
  return out;
}

std::string line_of_text(std::string_view text, std::uint32_t line) {
  std::size_t at = 0;
  for (std::uint32_t k = 1; k < line; ++k) {
    at = text.find('\n', at);
    if (at == text.npos) return "";
    ++at;
  }
  return line == 0 ? "" : std::string(io::trimmed(text.substr(at, text.find('\n', at) - at)));
}

Declared parse_parameter(const std::string& text) {
  const std::string where = "--param '" + text + "': ";
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0)
    throw InputError(where + "must be NAME=MIN:MAX or NAME=MIN:MAX:DEFAULT, with :log for a log scale");
  std::vector<std::string_view> fields;
  io::split(std::string_view(text).substr(equals + 1), ':', fields);
  Declared p{std::string(io::trimmed(std::string_view(text).substr(0, equals)))};
  if (!fields.empty() && fields.back() == "log") {
    p.log_scale = true;
    fields.pop_back();
  }
  if (fields.size() < 2 || fields.size() > 3)
    throw InputError(where + "must be NAME=MIN:MAX or NAME=MIN:MAX:DEFAULT, with :log for a log scale");
  p.min = number_of(fields[0], where), p.max = number_of(fields[1], where);
  if (fields.size() == 3) p.initial = {number_of(fields[2], where)};
  check(p, where);
  return p;
}

EntryLine parse_entry(const std::string& text) {
  EntryLine entry{std::string(io::trimmed(text))};
  const std::size_t open = text.find('(');
  if (open != text.npos) {
    const std::size_t close = text.find(')', open);
    if (close == text.npos) throw InputError("entry '" + text + "': must be NAME or NAME(L, V, N, ...)");
    entry.name = io::trimmed(std::string_view(text).substr(0, open));
    std::vector<std::string_view> fields;
    io::split(std::string_view(text).substr(open + 1, close - open - 1), ',', fields);
    entry.arguments.emplace();
    for (const std::string_view field : fields)
      if (!field.empty()) entry.arguments->emplace_back(field.substr(field.find_last_of(" \t") + 1));
  }
  if (entry.name.empty() || !std::all_of(entry.name.begin(), entry.name.end(), is_letter))
    throw InputError("entry '" + text + "': must be NAME or NAME(L, V, N, ...)");
  return entry;
}

Returns parse_returns(const std::string& text) {
  std::string word;
  for (const char c : text)
    if (c != ' ') word += c;
  const auto found = find_named<Returns>(word);
  if (!found) throw InputError("returns '" + text + "': must be one of " + known_names<Returns>());
  return *found;
}

Source parse_source(std::string name, std::string text, std::filesystem::path folder) {
  Source source{std::move(name), std::move(folder), std::move(text)};
  if (source.text.find('\0') != source.text.npos) throw InputError(source.name + ": is no text");
  std::erase(source.text, '\r');
  const std::string kind = io::lower_case(std::filesystem::path(source.name).extension().string());
  keep_shaders(source.text);
  const std::string bare = without_comments(source.text);
  check_language(source.name, bare);
  source.language = language_of(bare, kind);
  source.compute = source.language == Language::glsl && has_word(bare, "local_size_x");
  std::uint32_t number = 0;
  for (std::size_t at = 0; at < source.text.size();) {
    const std::size_t stop = std::min(source.text.find('\n', at), source.text.size());
    const std::string_view line = io::trimmed(std::string_view(source.text).substr(at, stop - at));
    ++number;
    if (line.starts_with("//:")) read_note(source, line.substr(3), number);
    at = stop + 1;
  }
  if (begins_a_block(source.text)) read_explorer(source);
  check_depth(source.name, without_comments(source.text));
  return source;
}

Source read_source(const std::filesystem::path& path) {
  io::Content content = io::read_content(path, kLargestShader);
  return parse_source(content.name, std::move(content.bytes), std::filesystem::absolute(path).parent_path());
}

}  // namespace brdf::shader
