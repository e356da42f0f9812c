#include "shader/front/glslang.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <memory>
#include <mutex>

#include "io/content.h"
#include "io/error.h"
#include "io/text.h"
#include "shader/front/texts.h"

namespace brdf::shader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepestInclude = 16, kMostIncludes = 200, kMostMessages = 3;

// Files of the shader's own folder, and no others.
class FolderIncluder final : public glslang::TShader::Includer {
 public:
  explicit FolderIncluder(const Source& source) : source_(source) {}

  IncludeResult* includeLocal(const char* name, const char*, std::size_t depth) override {
    return include(name, depth);
  }
  IncludeResult* includeSystem(const char* name, const char*, std::size_t depth) override {
    return include(name, depth);
  }
  void releaseInclude(IncludeResult* result) override {
    if (!result) return;
    delete static_cast<std::string*>(result->userData);
    delete result;
  }
  const std::string& refused() const { return refused_; }

 private:
  IncludeResult* include(const std::string& name, std::size_t depth) {
    std::error_code error;
    const fs::path folder = fs::canonical(source_.folder, error);
    const fs::path file = error ? fs::path() : fs::canonical(folder / name, error);
    const auto inside = [&] {
      const auto [end, unused] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
      return end == folder.end();
    };
    if (source_.folder.empty() || error || !inside() || !fs::is_regular_file(file, error)) {
      if (refused_.empty())
        refused_ = source_.name + ": #include " + io::shown(name) +
                   ": is no file of the shader's own folder; put it there, or delete the line if the "
                   "function needs nothing of it";
      return nullptr;
    }
    if (depth > kDeepestInclude || ++count_ > kMostIncludes) {
      if (refused_.empty())
        refused_ = source_.name + ": #include " + io::shown(name) + ": includes are nested too deeply";
      return nullptr;
    }
    auto text = std::make_unique<std::string>(io::read_content(file, kLargestShader).bytes);
    const char* const data = text->data();
    const std::size_t size = text->size();
    return new IncludeResult(file.string(), data, size, text.release());
  }

  const Source& source_;
  std::string refused_;
  std::size_t count_ = 0;
};

// "ERROR: 0:12: 'x' : undeclared identifier" as "FILE:12: 'x' : undeclared identifier", the first few.
std::string messages_of(const Source& source, const std::string& log) {
  std::string out;
  std::size_t count = 0;
  for (std::size_t at = 0; at < log.size() && count < kMostMessages;) {
    const std::size_t stop = std::min(log.find('\n', at), log.size());
    std::string line = log.substr(at, stop - at);
    at = stop + 1;
    if (!line.starts_with("ERROR: ") || line.find("compilation errors") != line.npos) continue;
    line = line.substr(7);
    if (line.starts_with(source.name + ":")) line = "0" + line.substr(source.name.size());
    const std::size_t colon = line.find(':');
    const bool placed =
        colon != line.npos && line.substr(0, colon).find_first_not_of("0123456789") == line.npos;
    line = io::printable(placed ? ":" + line.substr(colon + 1) : ": " + line, 300);
    if (line.find("compilation terminated") != line.npos) continue;
    out += (count++ > 0 ? "\n" : "") + source.name + line;
  }
  return out.empty() ? source.name + ": does not compile" : out;
}

Translated translate_with(const Source& source, const Attempt& attempt) {
  const bool hlsl = source.language == Language::hlsl;
  const std::string text = with_entry(source), name = source.name;
  glslang::TShader shader(EShLangFragment);
  const char* strings[] = {text.c_str()};
  const int lengths[] = {int(text.size())};
  const char* names[] = {name.c_str()};
  shader.setStringsWithLengthsAndNames(strings, lengths, names, 1);
  const std::string preamble =
      (hlsl ? "" : "#extension GL_GOOGLE_include_directive : enable\n") + attempt.preamble;
  shader.setPreamble(preamble.c_str());
  shader.setEnvInput(hlsl ? glslang::EShSourceHlsl : glslang::EShSourceGlsl, EShLangFragment,
                     glslang::EShClientOpenGL, 100);
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
    out.messages = messages_of(source, shader.getInfoLog());
    return out;
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(rules) || !program.mapIO()) {
    out.messages = messages_of(source, program.getInfoLog());
    return out;
  }
  glslang::SpvOptions options;
  options.disableOptimizer = true;
  options.generateDebugInfo = true;
  // Without these glslang 12 takes the top of an empty stack wherever braces are nested.
  options.emitNonSemanticShaderDebugInfo = true;
  std::vector<unsigned int> words;
  glslang::GlslangToSpv(*program.getIntermediate(EShLangFragment), words, &options);
  out.spirv.assign(words.begin(), words.end());
  out.note = attempt.note;
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
  std::string first;
  for (const Attempt& attempt : attempts(source)) {
    Translated out = translate_with(source, attempt);
    if (!out.spirv.empty()) return out;
    if (first.empty()) first = std::move(out.messages);
  }
  return {{}, "", first};
}

}  // namespace brdf::shader
