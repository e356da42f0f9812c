#include "shader/front/messages.h"

#include <algorithm>
#include <cstdlib>
#include <regex>

#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::shader {
namespace {

// Returns whether the text itself defines the type.
bool defines_type(std::string_view bare, std::string_view type) {
  const std::vector<Token> tokens = tokens_of(bare, true);
  bool in_typedef = false;
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    in_typedef = tokens[k].is("typedef") || (in_typedef && !tokens[k].is(";"));
    if (k == 0 || !tokens[k].is(type)) continue;
    if (tokens[k - 1].is("struct") || tokens[k - 1].is("class") || tokens[k - 1].is("define")) return true;
    if (in_typedef && k + 1 < tokens.size() && tokens[k + 1].is(";")) return true;
  }
  return false;
}

// A type in the head of the function on this line that neither the language nor a file defines; empty if
// all types are defined.
std::string unknown_type(const Files& files, const IncludedFile& file, std::uint32_t line) {
  static const std::regex known(
      "void|bool|int|float|double|half|real|fixed|uint|dword|min(10|12|16)\\w+|[biud]?vec[234]|d?mat[234]("
      "x[234])?|"
      "(float|half|real|fixed|int|uint|bool|double)[1-4](x[1-4])?|[iu]?(sampler|image)\\w+|(RW)?(Texture|"
      "Sampler|Buffer)\\w+");
  static const std::regex qualifier(
      "const|in|out|inout|highp|mediump|lowp|precise|uniform|static|inline|row_major|"
      "column_major|nointerpolation|linear|flat|smooth|centroid");
  constexpr std::size_t kLongest = 100;  // longest accepted name of a type
  for (const Definition& d : definitions_of(file.bare)) {
    if (line < d.first_line || line > d.last_line) continue;
    const std::string head = file.bare.substr(d.begin, file.bare.find('{', d.begin) - d.begin);
    const std::size_t open = head.find('('), close = head.rfind(')');
    if (open == head.npos || close == head.npos || close < open) return "";
    std::vector<std::string_view> fields, words;
    const std::string inner = head.substr(open + 1, close - open - 1);
    io::split(inner, ',', fields);
    for (const std::string_view field : fields) {
      std::string spaced(field);
      std::ranges::replace(spaced, '\n', ' ');
      io::split_blanks(spaced, words);
      std::erase_if(words, [](std::string_view w) { return w.size() > kLongest; });
      const auto type =
          std::ranges::find_if(words, [](auto w) { return !std::regex_match(std::string(w), qualifier); });
      if (type == words.end() || std::regex_match(std::string(*type), known)) continue;
      if (std::none_of(files.all().begin(), files.all().end(),
                       [&](const auto& f) { return defines_type(f.second.bare, *type); }))
        return std::string(*type);
    }
  }
  return "";
}

// The compiler's wording for unknown names, in GLSL and HLSL.
constexpr const char* kUnknown[] = {"undeclared identifier", "no matching overloaded", "unknown variable"};

bool says(const std::string& message, std::string_view words) {
  return message.find(words) != message.npos;
}

// The first quoted text of the message; empty if the message quotes nothing.
std::string quoted_in(const std::string& message) {
  const std::size_t begin = message.find('\''),
                    end = begin == message.npos ? begin : message.find('\'', begin + 1);
  return end == message.npos ? "" : message.substr(begin + 1, end - begin - 1);
}

// The parameter of a `//:` line with the name that the message quotes first; null if no line has this name.
const Declared* declared_alone(const Source& source, const std::string& message) {
  const std::string name = quoted_in(message);
  const auto p = std::ranges::find_if(source.parameters, [&](const Declared& d) { return d.name == name; });
  return p == source.parameters.end() ? nullptr : &*p;
}

// Removes "12:" from the beginning of the message. Returns false if the message does not begin with a line
// number.
bool take_line(std::string& message, std::uint32_t& line) {
  const std::size_t colon = message.find(':');
  if (colon == message.npos || colon == 0 || message.find_first_not_of("0123456789") != colon) return false;
  line = std::uint32_t(std::strtoul(message.c_str(), nullptr, 10));
  message.erase(0, colon + 1);
  return true;
}

// Removes "FILE:12:" from the beginning of the message, with the name of any known file in place of FILE.
bool take_place(std::string& message, const Files& files, const Source& source, Translated& out) {
  const auto after = [&](const std::string& name) {
    if (name.empty() || !message.starts_with(name + ":")) return false;
    std::string rest = message.substr(name.size() + 1);
    if (!take_line(rest, out.line)) return false;
    message = std::move(rest);
    return true;
  };
  for (const auto& [path, file] : files.all()) {
    if (!after(path)) continue;
    out.file = path;
    return true;
  }
  out.file.clear();
  return after(source.name) || after("0");
}

// Recognises a line "Recursion detected:" followed by a line "f(f1; calling g(f1;" in the log, and finds
// the line of the call.
bool take_recursion(Translated& out, const Files& files, const std::string& log) {
  const std::size_t at = log.find("Recursion detected:"), line = log.find('\n', at);
  if (at == log.npos || line == log.npos) return false;
  const std::string pair = log.substr(line + 1, log.find('\n', line + 1) - line - 1);
  const std::size_t calling = pair.find(" calling ");
  if (calling == pair.npos) return false;
  const auto name_in_pair = [&](std::size_t begin) {
    const std::string_view rest = io::trimmed(std::string_view(pair).substr(begin));
    return std::string(rest.substr(0, rest.find('(')));
  };
  const std::string caller = name_in_pair(0), callee = name_in_pair(calling + 9);
  for (const auto& [path, file] : files.all())
    for (const Definition& d : definitions_of(file.bare)) {
      if (d.name != caller) continue;
      const std::vector<Token> tokens =
          tokens_of(std::string_view(file.bare).substr(d.begin, d.end - d.begin));
      const auto body = std::ranges::find_if(tokens, [](const Token& t) { return t.is("{"); });
      for (auto t = body; t != tokens.end(); ++t) {
        if (!t->is(callee) || t + 1 == tokens.end() || !(t + 1)->is("(")) continue;
        out.file = path;
        out.line = d.first_line + t->line - 1;
        out.messages =
            file.shown + ":" + std::to_string(out.line) + ": " + caller + "() " +
            (caller == callee ? "calls itself" : "calls " + callee + "(), which leads back to it") +
            ": shaders do not support recursion; use a loop";
        return true;
      }
    }
  return false;
}

// Advice on how to correct the error; empty if the message is sufficient.
std::string advice(const Translated& out, const Source& source) {
  if (const Declared* p = declared_alone(source, out.messages);
      p && std::any_of(std::begin(kUnknown), std::end(kUnknown),
                       [&](const char* said) { return says(out.messages, said); }))
    return "; line " + std::to_string(p->line) + " makes it a parameter: declare it, as in `uniform " +
           (p->initial.size() > 1 ? "vec3 " : "float ") + p->name + ";`";
  if (says(out.messages, "'#error'") && !out.asked.empty())
    return "; not defined: " + io::joined(out.asked) + "; define a macro with --define NAME or NAME=VALUE";
  if (says(out.messages, "Macro redefined"))
    for (const std::string& define : source.defines)
      if (out.messages.ends_with(" " + define.substr(0, define.find('='))))
        return "; --define " + define + " gives a different value: remove one of the two";
  return "";
}

}  // namespace

void take_messages(Translated& out, const Files& files, const Source& source, const std::string& log,
                   const std::vector<std::string>& missing) {
  out.line = 0;
  const bool recursive = take_recursion(out, files, log);
  for (std::size_t at = 0; at < log.size() && out.messages.empty();) {
    const std::size_t stop = std::min(log.find('\n', at), log.size());
    std::string line = log.substr(at, stop - at);
    at = stop + 1;
    if (!line.starts_with("ERROR: ") || says(line, "compilation errors") ||
        says(line, "compilation terminated"))
      continue;
    line = line.substr(7);
    const bool placed = take_place(line, files, source, out);
    const std::string where = files.find(out.file)->shown + (placed ? ":" + std::to_string(out.line) : "");
    out.messages = where + ": " + std::string(io::trimmed(io::printable(line, 300)));
  }
  if (out.messages.empty()) out.messages = source.name + ": does not compile";
  std::string hint = recursive ? "" : advice(out, source);
  if (hint.empty() && !recursive) {
    const IncludedFile& file = *files.find(out.file);
    const bool syntax = says(out.messages, "syntax error") || says(out.messages, "Expected");
    const std::string type = syntax ? unknown_type(files, file, out.line) : "";
    if (!type.empty())
      out.messages = file.shown + ":" + std::to_string(out.line) + ": the type " + type + " is not defined";
    if (!type.empty() || std::any_of(std::begin(kUnknown), std::end(kUnknown),
                                     [&](const char* said) { return says(out.messages, said); }))
      hint =
          "; add the missing definition to the file, or #include a file of the shader's folder that has it";
  }
  out.messages += hint;
  if (!missing.empty()) out.messages += " (" + no_files(missing, source) + ")";
}

}  // namespace brdf::shader
