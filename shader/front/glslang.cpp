#include "shader/front/glslang.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <mutex>
#include <optional>
#include <regex>

#include "io/content.h"
#include "io/error.h"
#include "io/numbers.h"
#include "io/text.h"
#include "shader/front/definitions.h"
#include "shader/front/texts.h"

namespace brdf::shader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepestInclude = 16, kMostIncludes = 200;
constexpr int kMostSeconds = 2;  // of the processor, for a text that compiles in part

std::string no_files(const std::vector<std::string>& names) {
  return io::joined(names) + (names.size() > 1 ? " are no files" : " is no file") +
         " of the shader's own folder";
}

// Files of the shader's own folder, and no others. One that is not there is empty: the function may need nothing of it.
class FolderIncluder final : public glslang::TShader::Includer {
 public:
  explicit FolderIncluder(const Source& source) : source_(source) {
    std::error_code error;
    if (!source.folder.empty()) folder_ = fs::canonical(source.folder, error);
  }

  IncludeResult* includeLocal(const char* name, const char* from, std::size_t depth) override {
    return include(name, from, depth);
  }
  IncludeResult* includeSystem(const char* name, const char* from, std::size_t depth) override {
    return include(name, from, depth);
  }
  void releaseInclude(IncludeResult* result) override {
    if (!result) return;
    delete static_cast<std::string*>(result->userData);
    delete result;
  }
  const std::string& refused() const { return refused_; }
  // Names that no file of the folder has.
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  // A file inside the folder, else nothing.
  std::optional<fs::path> inside(const fs::path& path) const {
    std::error_code error;
    const fs::path file = fs::canonical(path, error);
    if (error) return std::nullopt;
    const auto [end, unused] = std::mismatch(folder_.begin(), folder_.end(), file.begin(), file.end());
    return end == folder_.end() && fs::is_regular_file(file, error) ? std::optional(file) : std::nullopt;
  }

  // As written, from the folder or from the file that includes it; else without the first parts of its path: libraries count
  // from a folder further up.
  std::optional<fs::path> find(const fs::path& name, const fs::path& from) const {
    if (folder_.empty()) return std::nullopt;
    if (const auto file = inside(folder_ / name)) return file;
    if (from.is_absolute())
      if (const auto file = inside(from.parent_path() / name)) return file;
    for (auto part = name.begin(); part != name.end();) {
      fs::path rest;
      for (auto k = ++part; k != name.end(); ++k) rest /= *k;
      if (const auto file = rest.empty() ? std::nullopt : inside(folder_ / rest)) return file;
    }
    return std::nullopt;
  }

  IncludeResult* include(const std::string& name, const fs::path& from, std::size_t depth) {
    if (depth > kDeepestInclude || ++count_ > kMostIncludes) {
      if (refused_.empty())
        refused_ = source_.name + ": #include " + io::shown(name) + ": includes are nested too deeply";
      return nullptr;
    }
    const auto file = find(name, from);
    if (!file) {
      const std::string shown = io::shown(name);
      if (std::find(missing_.begin(), missing_.end(), shown) == missing_.end()) missing_.push_back(shown);
      return new IncludeResult("missing", "", 0, nullptr);
    }
    auto text = std::make_unique<std::string>(io::read_content(*file, kLargestShader).bytes);
    const char* const data = text->data();
    const std::size_t size = text->size();
    return new IncludeResult(file->string(), data, size, text.release());
  }

  const Source& source_;
  fs::path folder_;
  std::string refused_;
  std::vector<std::string> missing_;
  std::size_t count_ = 0;
};

// A type in the head of the function on that line that neither the language nor the text has.
std::string unknown_type(const std::string& text, std::uint32_t line) {
  static const std::regex known(
      "void|bool|int|float|double|half|real|fixed|uint|dword|min(10|12|16)\\w+|[biud]?vec[234]|d?mat[234]("
      "x[234])?|"
      "(float|half|real|fixed|int|uint|bool|double)[1-4](x[1-4])?|[iu]?(sampler|image)\\w+|(RW)?(Texture|"
      "Sampler|Buffer)\\w+");
  static const std::regex qualifier(
      "const|in|out|inout|highp|mediump|lowp|precise|uniform|static|inline|row_major|"
      "column_major|nointerpolation|linear|flat|smooth|centroid");
  for (const Definition& d : definitions_of(text)) {
    if (line < d.first_line || line > d.last_line) continue;
    const std::string head = text.substr(d.begin, text.find('{', d.begin) - d.begin);
    const std::size_t open = head.find('('), close = head.rfind(')');
    if (open == head.npos || close == head.npos || close < open) return "";
    std::vector<std::string_view> fields, words;
    const std::string inner = head.substr(open + 1, close - open - 1);
    io::split(inner, ',', fields);
    for (const std::string_view field : fields) {
      std::string spaced(field);
      std::replace(spaced.begin(), spaced.end(), '\n', ' ');
      io::split_blanks(spaced, words);
      const auto type = std::find_if(words.begin(), words.end(),
                                     [](auto w) { return !std::regex_match(std::string(w), qualifier); });
      if (type == words.end() || std::regex_match(std::string(*type), known)) continue;
      if (!std::regex_search(
              text, std::regex("(struct|define|typedef[^;]*|class)\\s+" + std::string(*type) + "\\b")))
        return std::string(*type);
    }
  }
  return "";
}

// What the front end says of a name that it does not know, in GLSL and HLSL.
constexpr const char* kUnknown[] = {"undeclared identifier", "no matching overloaded", "unknown variable"};

// The parameter of a `//:` line whose name the message quotes; null without.
const Declared* declared_alone(const Source& source, const std::string& message) {
  const std::size_t begin = message.find('\''),
                    end = begin == message.npos ? begin : message.find('\'', begin + 1);
  if (end == message.npos) return nullptr;
  const std::string name = message.substr(begin + 1, end - begin - 1);
  const auto p = std::find_if(source.parameters.begin(), source.parameters.end(),
                              [&](const Declared& d) { return d.name == name; });
  return p == source.parameters.end() ? nullptr : &*p;
}

// "ERROR: 0:12: 'x' : undeclared identifier" as "FILE:12: 'x' : undeclared identifier", the first: others follow from it.
void take_messages(Translated& out, const Source& source, const std::string& log,
                   const std::vector<std::string>& missing) {
  for (std::size_t at = 0; at < log.size() && out.messages.empty();) {
    const std::size_t stop = std::min(log.find('\n', at), log.size());
    std::string line = log.substr(at, stop - at);
    at = stop + 1;
    if (!line.starts_with("ERROR: ") || line.find("compilation errors") != line.npos ||
        line.find("compilation terminated") != line.npos)
      continue;
    line = line.substr(7);
    if (line.starts_with(source.name + ":")) line = "0" + line.substr(source.name.size());
    const std::size_t colon = line.find(':');
    const bool placed =
        colon != line.npos && line.substr(0, colon).find_first_not_of("0123456789") == line.npos;
    if (placed) out.line = std::uint32_t(std::strtoul(line.c_str() + colon + 1, nullptr, 10));
    out.messages =
        source.name +
        std::string(io::trimmed(io::printable(placed ? ":" + line.substr(colon + 1) : ": " + line, 300)));
  }
  if (out.messages.empty()) out.messages = source.name + ": does not compile";
  const bool syntax = out.messages.find("syntax error") != out.messages.npos ||
                      out.messages.find("Expected") != out.messages.npos;
  if (const std::string type = syntax ? unknown_type(without_comments(source.text), out.line) : "";
      !type.empty())
    out.messages = source.name + ":" + std::to_string(out.line) + ": the type " + type + " is not defined";
  else if (std::none_of(std::begin(kUnknown), std::end(kUnknown),
                        [&](const char* said) { return out.messages.find(said) != out.messages.npos; }))
    return;
  if (const Declared* p = declared_alone(source, out.messages)) {
    out.messages += "; line " + std::to_string(p->line) +
                    " says that it is a parameter: declare it, as in `uniform " +
                    (p->initial.size() > 1 ? "vec3 " : "float ") + p->name + ";`";
    return;
  }
  out.messages +=
      "; write what is missing into the file, or put the file that has it into the shader's folder and "
      "#include it";
  if (!missing.empty()) out.messages += " (" + no_files(missing) + ")";
}

Translated translate_with(const Source& source, const Attempt& attempt) {
  const bool hlsl = source.language == Language::hlsl;
  const std::string text = with_entry(source), name = source.name;
  const EShLanguage stage = source.compute ? EShLangCompute : EShLangFragment;
  glslang::TShader shader(stage);
  const char* strings[] = {text.c_str()};
  const int lengths[] = {int(text.size())};
  const char* names[] = {name.c_str()};
  shader.setStringsWithLengthsAndNames(strings, lengths, names, 1);
  const std::string preamble =
      (hlsl ? "" : "#extension GL_GOOGLE_include_directive : enable\n") + attempt.preamble;
  shader.setPreamble(preamble.c_str());
  shader.setEnvInput(hlsl ? glslang::EShSourceHlsl : glslang::EShSourceGlsl, stage, glslang::EShClientOpenGL,
                     100);
  shader.setEnvClient(glslang::EShClientOpenGL, glslang::EShTargetOpenGL_450);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  shader.setAutoMapLocations(true);
  shader.setAutoMapBindings(true);
  shader.setEntryPoint(hlsl ? "brdf_main" : "main");
  shader.setDebugInfo(true);
  const auto rules = EShMessages(EShMsgSpvRules | EShMsgKeepUncalled | (hlsl ? int(EShMsgReadHlsl) : 0));
  FolderIncluder includer(source);
  Translated out;
  const bool parsed = shader.parse(GetDefaultResources(), attempt.version, hlsl ? ENoProfile : ECoreProfile,
                                   true, false, rules, includer);
  if (!includer.refused().empty()) {
    out.messages = includer.refused();
    return out;
  }
  if (!parsed) {
    take_messages(out, source, shader.getInfoLog(), includer.missing());
    return out;
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(rules) || !program.mapIO()) {
    take_messages(out, source, program.getInfoLog(), includer.missing());
    return out;
  }
  glslang::SpvOptions options;
  options.disableOptimizer = true;
  options.generateDebugInfo = true;
  // Without these glslang 12 takes the top of an empty stack wherever braces are nested.
  options.emitNonSemanticShaderDebugInfo = true;
  std::vector<unsigned int> words;
  glslang::GlslangToSpv(*program.getIntermediate(stage), words, &options);
  out.spirv.assign(words.begin(), words.end());
  out.note = attempt.note;
  if (!includer.missing().empty())
    out.note += (out.note.empty() ? "" : "; ") + no_files(includer.missing()) + ", and left away";
  return out;
}

// What lacks a declaration that was left out before does not compile for that one's reason.
std::string why(const std::vector<LeftOut>& before, const std::string& text, const std::string& message) {
  for (const LeftOut& d : before)
    if (d.is_declaration && std::regex_search(text, std::regex("\\b" + d.name + "\\b"))) return d.why;
  return message;
}

// Without the functions and declarations that the compiler stumbles over, one after the other; what needs them goes as well.
// `out`: what came of the whole.
Translated translate_in_part(Source source, const Attempt& attempt, Translated out, std::clock_t begin) {
  std::vector<Definition> parts = definitions_of(without_comments(source.text), true);
  std::vector<LeftOut> left_out;
  while (out.spirv.empty() && std::clock() - begin < kMostSeconds * CLOCKS_PER_SEC) {
    const auto faulty = std::find_if(parts.begin(), parts.end(), [&](const Definition& d) {
      return d.first_line <= out.line && out.line <= d.last_line;
    });
    if (out.line == 0 || faulty == parts.end()) break;
    left_out.push_back(
        {faulty->name,
         why(left_out, source.text.substr(faulty->begin, faulty->end - faulty->begin), out.messages),
         faulty->is_declaration});
    source.text = without(std::move(source.text), {&*faulty, 1});
    parts.erase(faulty);
    if (std::all_of(parts.begin(), parts.end(), [](const Definition& d) { return d.is_declaration; })) break;
    out = translate_with(source, attempt);
  }
  out.left_out = std::move(left_out);
  return out;
}

}  // namespace

void prepare_translation() {
  static std::once_flag once;
  std::call_once(once, [] {
    glslang::InitializeProcess();
    translate_with({"", {}, "float f() { return 1.0; }"}, {450, "", ""});
  });
}

Translated translate(const Source& source) {
  const std::clock_t begin = std::clock();
  const std::vector<Attempt> all = attempts(source);
  std::vector<Translated> failed;
  for (const Attempt& attempt : all) {
    failed.push_back(translate_with(source, attempt));
    if (!failed.back().spirv.empty()) return failed.back();
  }
  std::size_t newest = 0;  // version: its message is told
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!all[k].usual) continue;
    if (!all[newest].usual || all[k].version > all[newest].version) newest = k;
    Translated part = translate_in_part(source, all[k], failed[k], begin);
    if (!part.spirv.empty()) return part;
  }
  return failed[newest];
}

}  // namespace brdf::shader
