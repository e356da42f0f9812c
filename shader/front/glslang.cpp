#include "shader/front/glslang.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <ctime>
#include <mutex>

#include "io/files/text.h"
#include "shader/front/includes.h"
#include "shader/front/messages.h"
#include "shader/front/texts.h"
#include "shader/front/tree.h"

namespace brdf::shader {
namespace {

constexpr int kMostSeconds = 2;  // of processor time, for a text that compiles only in part

// The compilation of one text.
class Parse {
 public:
  Parse(Files& files, const Source& source, const Attempt& attempt)
      : hlsl_(source.language == Language::hlsl),
        version_(attempt.version),
        stage_(source.compute ? EShLangCompute : EShLangFragment),
        text_(with_entry(files.own().text, source.language)),
        name_(source.name),
        preamble_(attempt.preamble),
        includer_(files),
        shader_(stage_) {
    shader_.setStringsWithLengthsAndNames(&strings_, &length_, &names_, 1);
    shader_.setPreamble(preamble_.c_str());
    // Of desktop GLSL the compiler keeps mediump and lowp only by the rules of Vulkan.
    const bool vulkan = attempt.narrow && !hlsl_;
    shader_.setEnvInput(hlsl_ ? glslang::EShSourceHlsl : glslang::EShSourceGlsl, stage_,
                        vulkan ? glslang::EShClientVulkan : glslang::EShClientOpenGL, 100);
    if (vulkan) {
      shader_.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
      shader_.setEnvInputVulkanRulesRelaxed();
    } else {
      shader_.setEnvClient(glslang::EShClientOpenGL, glslang::EShTargetOpenGL_450);
    }
    shader_.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
    shader_.setAutoMapLocations(true);
    shader_.setAutoMapBindings(true);
    shader_.setEntryPoint(entry());
  }
  Parse(const Parse&) = delete;
  Parse& operator=(const Parse&) = delete;

  const char* entry() const { return hlsl_ ? "brdf_main" : "main"; }
  EShLanguage stage() const { return stage_; }
  const Includer& includer() const { return includer_; }
  glslang::TShader& shader() { return shader_; }
  EShMessages rules() const {
    return EShMessages(EShMsgSpvRules | EShMsgKeepUncalled | (hlsl_ ? int(EShMsgReadHlsl) : 0));
  }
  bool parse() {
    return shader_.parse(GetDefaultResources(), version_, hlsl_ ? ENoProfile : ECoreProfile, true, false,
                         rules(), includer_);
  }
  bool preprocess(std::string& out) {
    return shader_.preprocess(GetDefaultResources(), version_, hlsl_ ? ENoProfile : ECoreProfile, true, false,
                              rules(), &out, includer_);
  }

 private:
  bool hlsl_;
  int version_;
  EShLanguage stage_;
  std::string text_, name_, preamble_;
  const char* strings_ = text_.c_str();
  int length_ = int(text_.size());
  const char* names_ = name_.c_str();
  Includer includer_;
  glslang::TShader shader_;
};

// The text after the preprocessor; if the preprocessor fails, all files that were read, one after the
// other.
std::string preprocessed(Files& files, const Source& source, const Attempt& attempt) {
  std::string out;
  Parse parse(files, source, attempt);
  if (parse.preprocess(out)) return out;
  out.clear();
  for (const auto& [path, file] : files.all()) out += file.bare + "\n";
  return out;
}

Translated translate_with(Files& files, const Source& source, const Attempt& attempt, Places places) {
  Translated out;
  Parse parse(files, source, attempt);
  parse.shader().setDebugInfo(places != Places::none);
  const bool parsed = parse.parse();
  out.missing = parse.includer().missing();
  out.asked = asked_macros(files, source);
  out.unmentioned = unmentioned_macros(files, source);
  if (!parse.includer().refused().empty()) {
    out.messages = parse.includer().refused();
    return out;
  }
  glslang::TProgram program;
  program.addShader(&parse.shader());
  const bool linked = parsed && program.link(parse.rules()) && program.mapIO();
  if (!linked) {
    take_messages(out, files, source, parsed ? program.getInfoLog() : parse.shader().getInfoLog(),
                  out.missing);
    return out;
  }
  glslang::TIntermediate& tree = *program.getIntermediate(parse.stage());
  if (const auto call = call_without_body(tree)) {
    const std::string log = "ERROR: " + call->file + ":" + std::to_string(call->line) + ": calls " +
                            call->function + "(), which has no body in the files that were read";
    take_messages(out, files, source, log, out.missing);
    return out;
  }
  move_initialisers(tree, parse.entry());
  if (places != Places::scopes) remove_scopes(tree);
  glslang::SpvOptions options;
  options.disableOptimizer = true;
  options.generateDebugInfo = places != Places::none;
  options.emitNonSemanticShaderDebugInfo = places == Places::scopes;
  std::vector<unsigned int> words;
  glslang::GlslangToSpv(tree, words, &options);
  out.spirv.assign(words.begin(), words.end());
  out.note = attempt.note;
  if (!out.missing.empty())
    out.note += (out.note.empty() ? "" : "; ") + no_files(out.missing, source) + "; omitted";
  out.whole = preprocessed(files, source, attempt);
  out.ignores_narrow = !attempt.narrow;
  return out;
}

// The reason why this definition of the file does not compile: words of another language in it, or else a
// missing part that was left out before, or else the compiler's message.
std::string why(const std::vector<LeftOut>& before, const IncludedFile& file, const Definition& definition,
                const std::string& text, const std::string& message) {
  if (const auto foreign = foreign_language(text, message))
    return file.shown + ":" + std::to_string(definition.first_line + foreign->line - 1) + ": " +
           refusal_of(*foreign);
  const std::vector<Token> tokens = tokens_of(text);
  for (const LeftOut& d : before) {
    if (!d.is_declaration && message.find("'" + d.name + "'") != message.npos)
      return message.substr(0, message.find(": ")) + ": calls " + d.name +
             "(), which does not compile: " + d.why;
    if (d.is_declaration && std::ranges::any_of(tokens, [&](const Token& t) { return t.is(d.name); }))
      return d.why;
  }
  return message;
}

// The reason why no text of these files compiles, if they are in another language; empty if no other
// language is recognised. `newer`: also report newer versions of a known language, which is wrong while a
// part may still compile.
std::string of_another_language(const Files& files, const std::string& message, bool newer) {
  for (const auto& [path, file] : files.all())
    if (const auto foreign = foreign_language(
            file.bare, message, io::lower_case(std::filesystem::path(file.shown).extension().string()));
        foreign && (newer || !foreign->newer))
      return file.shown + ":" + std::to_string(foreign->line) + ": " + refusal_of(*foreign);
  return "";
}

bool holds_functions(const Files& files) {
  return std::any_of(files.all().begin(), files.all().end(),
                     [](const auto& f) { return !definitions_of(f.second.bare).empty(); });
}

// Translates without the functions and declarations that the compiler rejects, leaving out one after the
// other; parts that need them are rejected next. `out`: the result for the whole text.
Translated translate_in_part(Files files, const Source& source, const Attempt& attempt, Places places,
                             Translated out, std::clock_t begin) {
  std::vector<LeftOut> left_out;
  while (out.spirv.empty() && out.line > 0 && std::clock() - begin < kMostSeconds * CLOCKS_PER_SEC) {
    const IncludedFile& file = *files.find(out.file);
    const std::vector<Definition> parts = definitions_of(file.bare, true);
    const auto faulty = std::ranges::find_if(
        parts, [&](const Definition& d) { return d.first_line <= out.line && out.line <= d.last_line; });
    if (faulty == parts.end()) break;
    const std::string text = file.bare.substr(faulty->begin, faulty->end - faulty->begin);
    left_out.push_back(
        {faulty->name, why(left_out, file, *faulty, text, out.messages), text, faulty->is_declaration});
    files.leave_out(out.file, *faulty);
    if (!holds_functions(files)) break;
    out = translate_with(files, source, attempt, places);
  }
  out.left_out = std::move(left_out);
  return out;
}

}  // namespace

void prepare_translation() {
  static std::once_flag once;
  std::call_once(once, [] {
    glslang::InitializeProcess();
    const Source source{"", {}, "float f() { return 1.0; }"};
    Files files(source);
    translate_with(files, source, {450, "", ""}, Places::scopes);
  });
}

Translated translate(const Source& source, Places places) {
  const std::clock_t begin = std::clock();
  Files files(source);
  const std::string whole =
      preprocessed(files, source, {versions_of(source).front(), common_preamble(source), ""});
  const std::vector<Attempt> all = attempts(files, source, whole);
  // The error that is reported: of the first attempt with the rules that the text is written for.
  const auto told = std::size_t(std::ranges::find(all, false, &Attempt::narrow) - all.begin());
  const std::string narrow = narrow_word(whole, source.language);
  std::vector<Translated> failed;
  for (const Attempt& attempt : all) {
    failed.push_back(translate_with(files, source, attempt, places));
    failed.back().narrow_word = narrow;
    const std::vector<std::string>& missing = failed.back().missing;
    const bool metal = std::ranges::find(missing, "'metal_stdlib'") != missing.end();
    if (!failed.back().spirv.empty() && !metal) return failed.back();
    failed.back().spirv.clear();
  }
  // Later errors follow from the first error.
  if (const std::string foreign = of_another_language(files, failed[told].messages, false);
      !foreign.empty()) {
    failed[told].messages = foreign;
    return failed[told];
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].again) continue;
    Translated part = translate_in_part(files, source, all[k], places, failed[k], begin);
    part.narrow_word = narrow;
    if (!part.spirv.empty()) return part;
  }
  if (const std::string foreign = of_another_language(files, failed[told].messages, true); !foreign.empty())
    failed[told].messages = foreign;
  return failed[told];
}

}  // namespace brdf::shader
