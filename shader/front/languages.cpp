#include "shader/front/languages.h"

#include <algorithm>

#include "io/files/text.h"
#include "shader/front/definitions.h"

namespace brdf::shader {
namespace {

bool is_name(std::string_view word) {
  return !word.empty() && is_word(word[0]) && !(word[0] >= '0' && word[0] <= '9');
}

// The tokens from position `at` on; positions beyond the last token give an empty text.
class At {
 public:
  At(const std::vector<Token>& tokens, std::size_t at) : tokens_(tokens), at_(at) {}
  std::string_view operator[](std::size_t k) const {
    return at_ + k < tokens_.size() ? tokens_[at_ + k].text : std::string_view();
  }
  bool first() const { return tokens_[at_].first; }
  bool name(std::size_t k) const { return is_name((*this)[k]); }
  template <class... Words>
  bool are(Words... words) const {
    std::size_t k = 0;
    return (((*this)[k++] == words) && ...);
  }

 private:
  const std::vector<Token>& tokens_;
  std::size_t at_;
};

bool one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

bool is_wgsl(const At& t) {
  if (t.are("@") && t.name(1)) return true;
  if (t.are("var", "<") && one_of(t[2], {"private", "uniform", "storage", "workgroup", "function"}))
    return true;
  return one_of(t[0], {"vec2", "vec3", "vec4"}) && t[1] == "<" &&
         one_of(t[2], {"f32", "f16", "i32", "u32", "bool"});
}

bool is_slang(const At& t) {
  if (t.first() && (t.are("import") || t.are("module")) && t.name(1) && (t[2] == ";" || t[2] == "."))
    return true;
  if (t.first() && (t.are("interface") || t.are("extension")) && t.name(1) && one_of(t[2], {"{", ":", "<"}))
    return true;
  if (t.first() && (t.are("public") || t.are("internal")) && t.name(1)) return true;
  if (t.are("func") && t.name(1) && t[2] == "(") return true;
  if (t.name(0) && t[1] == "<" && t.name(2) && t[3] == ":" && t.name(4) && (t[5] == ">" || t[5] == ","))
    return true;  // f<T : ISomething>
  if (t.are("associatedtype") && t.name(1)) return true;
  if (t.are("__generic", "<") || t.are("no_diff") || t.are("[", "Differentiable", "]")) return true;
  return (t.are("let") || t.are("var")) && t.name(1) && (t[2] == ":" || (t[2] == "=" && t[3] != "="));
}

bool is_osl(const At& t) {
  if (t.are("closure", "color")) return true;
  if (!one_of(t[0], {"shader", "surface", "displacement", "volume"}) || !t.name(1) || t[2] != "(")
    return false;
  return t[0] == "shader" || one_of(t[3], {"output", "string", "color"}) || (t.name(4) && t[5] == "=");
}

bool is_mdl(const At& t) {
  if (t.first() && t.are("mdl") && !t[1].empty() && t[1][0] >= '0' && t[1][0] <= '9') return true;
  if (t.are("export", "material") || (t.first() && t.are("import", ":", ":"))) return true;
  return t.first() && t.are("using") && (t[1] == ":" || t[1] == "." || t[2] == "import");
}

bool is_hlsl_2021(const At& t, std::string_view message) {
  if (t.are("template", "<")) return true;
  if (t.are("operator") && t[1].size() == 1 && std::string_view("+-*/%=<>!&|^~[(").find(t[1]) != t[1].npos)
    return true;
  if (t.are("uint") && t.name(1) && t[2] == ":" && !t[3].empty() && t[3][0] >= '0' && t[3][0] <= '9')
    return true;
  if (t.are("enum") && t.name(1) && (t[2] == "{" || t[1] == "class")) return true;
  for (const std::string_view name : {"select", "and", "or"})
    if (t.are(name, "(") && message.find("'" + std::string(name) + "'") != message.npos) return true;
  return false;
}

bool is_cpp(const At& t) {
  return t.are("std", ":", ":") || t.are("glm", ":", ":") || t.are("__device__") || t.are("__kernel") ||
         t.are("__global__");
}

// The tokens of the construct, as written in the text.
std::string shown_tokens(const std::vector<Token>& tokens, std::size_t at, std::size_t count) {
  const std::size_t last = std::min(at + count, tokens.size()) - 1;
  const char* const begin = tokens[at].text.data();
  const char* const end = tokens[last].text.data() + tokens[last].text.size();
  std::string text(begin, end);
  text.resize(std::min({text.size(), text.find('\n'), std::size_t(40)}));
  return text;
}

}  // namespace

std::vector<Token> tokens_of(std::string_view bare, bool directives) {
  std::vector<Token> out;
  std::uint32_t line = 1;
  bool first = true;
  for (std::size_t at = 0; at < bare.size();) {
    const char c = bare[at];
    if (c == '\n' || c == ' ' || c == '\t' || c == '\f' || c == '\v') {
      line += c == '\n';
      first = first || c == '\n';
      ++at;
      continue;
    }
    if (c == '#' && first && !directives) {
      for (; at < bare.size() && (bare[at] != '\n' || bare[at - 1] == '\\'); ++at) line += bare[at] == '\n';
      continue;
    }
    std::size_t end = at + 1;
    if (is_word(c))
      while (end < bare.size() && is_word(bare[end])) ++end;
    out.push_back({bare.substr(at, end - at), line, first});
    first = false;
    at = end;
  }
  return out;
}

Language language_of(std::string_view bare, std::string_view suffix) {
  bool glsl = false, hlsl = false;
  for (const Token& t : tokens_of(bare, true)) {
    glsl = glsl || one_of(t.text, {"vec2", "vec3", "vec4"});
    hlsl = hlsl || one_of(t.text, {"float2", "float3", "float4", "half3", "half4", "cbuffer", "min16float3"});
  }
  if (glsl != hlsl) return hlsl ? Language::hlsl : Language::glsl;
  const bool by_suffix = std::ranges::find(kHlslSuffixes, suffix) != std::end(kHlslSuffixes);
  return by_suffix ? Language::hlsl : Language::glsl;
}

std::optional<Foreign> foreign_language(std::string_view bare, std::string_view message,
                                        std::string_view suffix) {
  const std::vector<Token> tokens = tokens_of(bare);
  const bool wgsl = [&] {
    for (std::size_t k = 0; k < tokens.size(); ++k)
      if (is_wgsl({tokens, k}) || one_of(tokens[k].text, {"f32", "vec3f"})) return true;
    return false;
  }();
  std::optional<Foreign> late;  // the weakest evidence, used if there is no other
  const auto found = [&](std::size_t at, const char* language, std::size_t count) {
    return Foreign{language, shown_tokens(tokens, at, count), tokens[at].line};
  };
  if (const std::size_t metal = bare.find("metal_stdlib"); metal != bare.npos)
    return Foreign{"Metal Shading Language", "metal_stdlib",
                   std::uint32_t(1 + std::count(bare.begin(), bare.begin() + long(metal), '\n'))};
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    const At t(tokens, k);
    if (t.are("fn") && t.name(1) && (t[2] == "(" || t[2] == "<"))
      return found(k, wgsl ? "WGSL" : "a language with the keyword fn (WGSL or Rust)", 3);
    if (is_wgsl(t)) return found(k, "WGSL", 3);
    if (t.are("using", "namespace", "metal")) return found(k, "Metal Shading Language", 3);
    if (is_osl(t)) return found(k, "Open Shading Language", 3);
    if (is_mdl(t)) return found(k, "MDL", 3);
    if (t.first() && t.are("shader_type") && t.name(1) && t[2] == ";")
      return found(k, "Godot's shading language", 3);
    if (is_slang(t)) {
      const bool of_hlsl = t.are("interface");
      return found(k, of_hlsl ? "Slang (or HLSL with interfaces)" : "Slang", 3);
    }
    if (is_cpp(t)) return found(k, "C++ or a dialect of it", 3);
    if (late || !is_hlsl_2021(t, message)) continue;
    late = found(k, t.are("enum") ? "HLSL newer than 5.1" : "HLSL 2021", 2);
    late->newer = true;
  }
  if (late) return late;
  for (const auto& [end, language] :
       {std::pair(".slang", "Slang"), std::pair(".wgsl", "WGSL"), std::pair(".osl", "Open Shading Language"),
        std::pair(".mdl", "MDL"), std::pair(".metal", "Metal Shading Language"), std::pair(".rs", "Rust")})
    if (suffix == end) return Foreign{language, std::string(suffix), 1};
  return std::nullopt;
}

std::string refusal_of(const Foreign& foreign) {
  const std::string begin =
      "is " + foreign.language + " (`" + io::printable(foreign.construct) + "`), which is not read: ";
  if (foreign.newer)
    return begin +
           "write the function in HLSL 5.1 (`c ? a : b` for select(), one function per type for a template, "
           "a named function for an operator, constants for an enum) or in GLSL";
  return begin +
         "write the function in GLSL or HLSL, such as `vec3 brdf(vec3 L, vec3 V, vec3 N, float k) { ... }`";
}

}  // namespace brdf::shader
