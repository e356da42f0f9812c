#include "shader/front/includes.h"

#include <algorithm>
#include <set>

#include "io/files/content.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "shader/front/glslang.h"
#include "shader/front/stripped.h"

namespace brdf::shader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepestInclude = 16, kMostIncludes = 200;

// Collects the macros that the text of one file tests and defines.
void read_macros(std::string_view bare, std::set<std::string>& asked, std::set<std::string>& defined) {
  const std::vector<Token> tokens = tokens_of(bare, true);
  const auto is_identifier = [&](std::size_t k) {
    return k < tokens.size() && is_word(tokens[k].text[0]) &&
           !(tokens[k].text[0] >= '0' && tokens[k].text[0] <= '9');
  };
  for (std::size_t k = 0; k + 1 < tokens.size(); ++k) {
    if (!tokens[k].is("#") || !tokens[k].first) continue;
    const Token& directive = tokens[k + 1];
    if (directive.line != tokens[k].line) continue;
    if (directive.is("define") || directive.is("undef")) {
      if (is_identifier(k + 2)) defined.emplace(tokens[k + 2].text);
    } else if (directive.is("ifdef") || directive.is("ifndef")) {
      if (is_identifier(k + 2)) asked.emplace(tokens[k + 2].text);
    } else if (directive.is("if") || directive.is("elif")) {
      std::uint32_t line = directive.line;
      for (std::size_t j = k + 2; j < tokens.size() && tokens[j].line == line; ++j) {
        if (tokens[j].is("\\")) ++line;  // continues on the next line
        if (is_identifier(j) && !tokens[j].is("defined")) asked.emplace(tokens[j].text);
      }
    }
  }
}

}  // namespace

Files::Files(const Source& source) : source_(source) {
  files_[""] = {source.name, source.text, source.bare};
  std::vector<fs::path> folders(source.include_folders.begin(), source.include_folders.end());
  if (!source.folder.empty()) folders.insert(folders.begin(), source.folder);
  for (const fs::path& folder : folders) {
    std::error_code error;
    const fs::path there = fs::canonical(folder, error);
    if (!error) folders_.push_back(there);
  }
}

const IncludedFile* Files::find(const std::string& path) const {
  const auto found = files_.find(path);
  return found == files_.end() ? nullptr : &found->second;
}

void Files::leave_out(const std::string& path, const Definition& definition) {
  IncludedFile& file = files_.at(path);
  file.text = without(std::move(file.text), {&definition, 1});
  file.bare = without(std::move(file.bare), {&definition, 1});
}

std::optional<fs::path> Files::inside(const fs::path& path) const {
  std::error_code error;
  const fs::path file = fs::canonical(path, error);
  if (error || !fs::is_regular_file(file, error)) return std::nullopt;
  for (const fs::path& folder : folders_)
    if (std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end())
      return file;
  return std::nullopt;
}

// Looks the name up as written, relative to the including file and then to the folders in their order. If
// that fails, the first parts of the path are dropped one by one, because libraries write paths relative to
// a folder further up.
std::optional<fs::path> Files::look_up(const fs::path& name, const fs::path& from) const {
  if (from.is_absolute())
    if (const auto file = inside(from.parent_path() / name)) return file;
  for (const fs::path& folder : folders_)
    if (const auto file = inside(folder / name)) return file;
  for (auto part = name.begin(); part != name.end();) {
    fs::path rest;
    for (auto k = ++part; k != name.end(); ++k) rest /= *k;
    if (rest.empty()) continue;
    for (const fs::path& folder : folders_)
      if (const auto file = inside(folder / rest)) return file;
  }
  return std::nullopt;
}

const IncludedFile* Files::include(const fs::path& name, const fs::path& from, std::string& path) {
  const auto file = look_up(name, from);
  if (!file) return nullptr;
  path = file->string();
  if (const IncludedFile* known = find(path)) return known;
  // A file next to the shader is shown with a path like the shader's, other files with their full path.
  fs::path shown = *file;
  if (!folders_.empty() && !source_.folder.empty()) {
    const fs::path relative = file->lexically_relative(folders_[0]);
    if (!relative.empty() && *relative.begin() != "..")
      shown = fs::path(source_.name).parent_path() / relative;
  }
  std::string text = text_of_bytes(shown.string(), io::read_content(*file, kLargestShader).bytes);
  text += '\n';  // the text after the #include begins on a line of its own
  std::string bare = stripped(text).text;
  return &(files_[path] = {shown.string(), std::move(text), std::move(bare)});
}

Includer::IncludeResult* Includer::include(const std::string& name, const std::string& from,
                                           std::size_t depth) {
  if (depth > kDeepestInclude || ++count_ > kMostIncludes) {
    if (refused_.empty())
      refused_ = files_.own().shown + ": #include " + io::shown(name) + ": includes are nested too deeply";
    return nullptr;
  }
  try {
    std::string path;
    if (const IncludedFile* file = files_.include(name, from, path))
      return new IncludeResult(path, file->text.data(), file->text.size(), nullptr);
  } catch (const std::exception& e) {  // exceptions must not pass through the compiler
    if (refused_.empty()) refused_ = e.what();
    return nullptr;
  }
  const std::string shown = io::shown(name);
  if (std::ranges::find(missing_, shown) == missing_.end()) missing_.push_back(shown);
  return new IncludeResult("missing", "", 0, nullptr);
}

std::string no_files(const std::vector<std::string>& names, const Source& source) {
  return io::joined(names) + (names.size() > 1 ? " are not files" : " is not a file") +
         " of the shader's own folder" + (source.include_folders.empty() ? "" : " or of a folder of -I");
}

std::vector<std::string> asked_macros(const Files& files, const Source& source) {
  std::set<std::string> asked, defined;
  for (const auto& [path, file] : files.all()) read_macros(file.bare, asked, defined);
  for (const std::string& define : source.defines) defined.insert(define.substr(0, define.find('=')));
  std::vector<std::string> out;
  for (const std::string& name : asked)
    if (!defined.contains(name) && !name.starts_with("GL_") && !name.starts_with("__")) out.push_back(name);
  return out;
}

std::vector<std::string> unmentioned_macros(const Files& files, const Source& source) {
  std::vector<std::string> out;
  for (const std::string& define : source.defines) out.push_back(define.substr(0, define.find('=')));
  for (const auto& [path, file] : files.all())
    for (const Token& token : tokens_of(file.bare, true))
      std::erase_if(out, [&](const std::string& name) { return token.is(name); });
  return out;
}

}  // namespace brdf::shader
