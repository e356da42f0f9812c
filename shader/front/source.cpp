#include "shader/front/source.h"

#include <algorithm>
#include <utility>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "shader/front/definitions.h"
#include "shader/front/module_file.h"
#include "shader/front/notes.h"
#include "shader/front/stripped.h"

namespace brdf::shader {
namespace {

constexpr int kDeepest = 100;                // nested brackets
constexpr std::size_t kLongestChain = 2000;  // operators without a semicolon, comma or brace in between

// Rejects text that would exhaust a compiler's stack.
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

// Converts a BRDF Explorer file to GLSL. Its parameters become globals on their original lines; other lines
// outside the shader become empty. Declarations in `//:` lines come last and take precedence.
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
      if (words.size() < 2) throw InputError(where + "::begin needs the name of a section");
      block = words[1];
      has_shader = has_shader || block == "shader";
    } else if (!words.empty() && words[0] == "::end") {
      block.clear();
    } else if (block == "shader") {
      glsl += line;
    } else if (block == "parameters" && !words.empty() && !words[0].starts_with("#") &&
               !words[0].starts_with("//")) {
      if (words[0] != "float" && words[0] != "bool" && words[0] != "color")
        throw InputError(where + "a parameter must be a float, a bool or a color");
      std::span<const std::string_view> rest = std::span<const std::string_view>(words).subspan(1);
      for (std::size_t k = 0; k < rest.size(); ++k)
        if (rest[k].starts_with("#") || rest[k].starts_with("//")) rest = rest.first(k);
      source.parameters.push_back(read_declared(words[0], rest, number, where));
      const std::string& name = source.parameters.back().name;
      if (!std::ranges::all_of(name, is_word)) throw InputError(where + io::shown(name) + " is not a name");
      source.globals.push_back(name);
      glsl += (words[0] == "color" ? "vec3 " : std::string(words[0]) + " ") + name + ";";
    }
    glsl += '\n';
  }
  if (!has_shader)
    throw InputError(source.name +
                     ": has no section ::begin shader, which must contain the function BRDF(L, V, N, X, Y) "
                     "in a .brdf file");
  source.parameters.insert(source.parameters.end(), noted.begin(), noted.end());
  source.text = std::move(glsl);
  if (!source.entry) source.entry = EntryLine{"BRDF"};
}

bool begins_a_block(std::string_view text) {
  return text.starts_with("::begin") || text.find("\n::begin") != std::string_view::npos;
}

}  // namespace

std::string line_of_text(std::string_view text, std::uint32_t line) {
  std::size_t at = 0;
  for (std::uint32_t k = 1; k < line; ++k) {
    at = text.find('\n', at);
    if (at == text.npos) return "";
    ++at;
  }
  return line == 0 ? "" : std::string(io::trimmed(text.substr(at, text.find('\n', at) - at)));
}

Source parse_source(std::string name, std::string text, std::filesystem::path folder) {
  if (is_module(text)) {
    Source source{name, std::move(folder), ""};
    source.module = module_words(name, text);
    return source;
  }
  text = text_of_bytes(name, std::move(text));
  Source source{std::move(name), std::move(folder), std::move(text)};
  const std::string kind = io::lower_case(std::filesystem::path(source.name).extension().string());
  if (is_script(kind)) keep_template_literals(source.name, source.text);
  if (is_unity(kind)) keep_programs(source.text);
  Stripped bare = stripped(source.text);
  if (!is_unity(kind) && holds_program(bare.text))
    throw InputError(source.name +
                     ": contains a program of Unity's ShaderLab: rename the file to the suffix .shader");
  source.language = language_of(bare.text, kind);
  std::uint32_t number = 1;
  std::size_t counted = 0;
  for (const std::size_t at : bare.line_notes) {
    for (; counted < at; ++counted) number += source.text[counted] == '\n';
    std::string_view line = std::string_view(source.text).substr(at);
    line = line.substr(0, line.find('\n'));
    if (line.starts_with("//:")) read_note(source, line.substr(3), number);
  }
  // Before its first block a .brdf file contains free text, in which a quote or a comment may be left open.
  if (begins_a_block(kind == ".brdf" ? source.text : bare.text)) {
    read_explorer(source);
    bare = stripped(source.text);
  }
  source.bare = std::move(bare.text);
  const std::vector<Token> tokens = tokens_of(source.bare);
  source.compute = source.language == Language::glsl &&
                   std::ranges::any_of(tokens, [](const Token& t) { return t.is("local_size_x"); });
  check_depth(source.name, source.bare);
  return source;
}

Source read_source(const std::filesystem::path& path) {
  io::Content content = io::read_content(path, kLargestModule);
  if (!is_module(content.bytes) && content.bytes.size() > kLargestShader)
    throw InputError(content.name + ": is larger than " + std::to_string(kLargestShader >> 10) +
                     " KiB, the largest text of a shader");
  return parse_source(content.name, std::move(content.bytes), std::filesystem::absolute(path).parent_path());
}

}  // namespace brdf::shader
