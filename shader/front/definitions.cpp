#include "shader/front/definitions.h"

#include <algorithm>
#include <string_view>

namespace brdf::shader {
namespace {

// The position after the preprocessor line that begins at `at`, including its continuation lines.
std::size_t after_directive(const std::string& text, std::size_t at) {
  for (;;) {
    const std::size_t stop = text.find('\n', at);
    if (stop == text.npos) return text.size();
    if (stop == 0 || text[stop - 1] != '\\') return stop;
    at = stop + 1;
  }
}

// The name in "TYPE NAME(ARGUMENTS) : SEMANTIC"; empty if the text is not the head of a function.
std::string name_in(std::string_view head) {
  const std::size_t open = head.find('(');
  const std::size_t close = head.rfind(')');
  if (open == head.npos || close == head.npos || close < open) return "";
  // HLSL attributes come first: [numthreads(8, 8, 1)] void f().
  if (const std::size_t bracket = head.rfind(']', close); bracket != head.npos && bracket > open)
    return name_in(head.substr(bracket + 1));
  std::size_t end = open;
  while (end > 0 && (head[end - 1] == ' ' || head[end - 1] == '\n' || head[end - 1] == '\t')) --end;
  std::size_t begin = end;
  while (begin > 0 && is_word(head[begin - 1])) --begin;
  const std::string_view before = head.substr(0, begin);
  const bool typed = std::ranges::any_of(before, is_word);
  return typed && head.find('=') == head.npos ? std::string(head.substr(begin, end - begin)) : "";
}

// The declared name: a for "uniform float a[4] = ...", b for "uniform Block { ... } b".
std::string last_name(std::string_view declaration) {
  if (const std::size_t brace = declaration.rfind('}'); brace != declaration.npos)
    declaration = declaration.substr(brace + 1);
  declaration = declaration.substr(0, declaration.find_first_of("=["));
  while (!declaration.empty() && !is_word(declaration.back())) declaration.remove_suffix(1);
  std::size_t begin = declaration.size();
  while (begin > 0 && is_word(declaration[begin - 1])) --begin;
  return std::string(declaration.substr(begin));
}

}  // namespace

std::vector<Definition> definitions_of(const std::string& text, bool declarations) {
  std::vector<Definition> out;
  int depth = 0;
  // The beginning of the text before the next brace or semicolon.
  std::size_t head = 0;
  std::string function;  // its name, while inside its braces
  const auto add = [&](const std::string& name, std::size_t end, bool is_declaration) {
    while (head < end && !is_word(text[head]) && text[head] != '[') ++head;
    if (!name.empty()) out.push_back({name, head, end, 0, 0, is_declaration});
    head = end;
  };
  bool line_begins = true;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (line_begins && c == '#') {
      at = after_directive(text, at);
      if (depth == 0) head = at;
      continue;
    }
    line_begins = c == '\n' || (line_begins && (c == ' ' || c == '\t'));
    if (c == '{' && depth++ == 0) {
      function = name_in(std::string_view(text).substr(head, at - head));
    } else if (c == '}' && depth > 0 && --depth == 0) {
      if (!function.empty()) add(function, at + 1, false);
    } else if (c == ';' && depth == 0) {
      if (declarations) add(last_name(std::string_view(text).substr(head, at - head)), at + 1, true);
      head = at + 1;
    }
  }
  std::size_t counted = 0;
  std::uint32_t line = 1;
  const auto line_at = [&](std::size_t place) {
    for (; counted < place; ++counted) line += text[counted] == '\n';
    return line;
  };
  for (Definition& d : out) {
    d.first_line = line_at(d.begin);
    d.last_line = line_at(d.end - 1);
  }
  return out;
}

std::string without(std::string text, std::span<const Definition> left_out) {
  for (const Definition& d : left_out)
    for (std::size_t k = d.begin; k < d.end && k < text.size(); ++k)
      if (text[k] != '\n') text[k] = ' ';
  return text;
}

}  // namespace brdf::shader
