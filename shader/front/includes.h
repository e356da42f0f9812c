// The files that a shader's text consists of: its own, and those that it includes.
#pragma once

#include <glslang/Public/ShaderLang.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "shader/front/definitions.h"
#include "shader/front/source.h"

namespace brdf::shader {

struct IncludedFile {
  std::string shown;       // its name for messages
  std::string text, bare;  // as of a Source; what is left out of the one is left out of the other
};

// All that was read so far. Included files are read once, so that what is left out of one stays out of it.
class Files {
 public:
  // The source must outlive this. Folders that are not there hold nothing.
  explicit Files(const Source& source);

  // "" is the shader's own file; others go by their paths. Null: no such file was read.
  const IncludedFile* find(const std::string& path) const;
  const IncludedFile& own() const { return files_.at(""); }
  const std::map<std::string, IncludedFile>& all() const { return files_; }
  void leave_out(const std::string& path, const Definition& definition);

  // The file that an #include of `name` in the file `from` means: below the shader's own folder or one of -I,
  // links resolved. Nothing where there is none.
  const IncludedFile* include(const std::filesystem::path& name, const std::filesystem::path& from,
                              std::string& path);

 private:
  std::optional<std::filesystem::path> inside(const std::filesystem::path& path) const;
  std::optional<std::filesystem::path> look_up(const std::filesystem::path& name,
                                               const std::filesystem::path& from) const;

  const Source& source_;
  std::vector<std::filesystem::path> folders_;  // the shader's own first
  std::map<std::string, IncludedFile> files_;
};

// What the compiler asks while it reads a text once. A file that is not there is empty: the function may need
// nothing of it.
class Includer final : public glslang::TShader::Includer {
 public:
  explicit Includer(Files& files) : files_(files) {}

  IncludeResult* includeLocal(const char* name, const char* from, std::size_t depth) override {
    return include(name, from, depth);
  }
  IncludeResult* includeSystem(const char* name, const char* from, std::size_t depth) override {
    return include(name, from, depth);
  }
  void releaseInclude(IncludeResult* result) override { delete result; }
  // Why the text is not read further; empty: it was.
  const std::string& refused() const { return refused_; }
  // Names that no file has, in quotes.
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  IncludeResult* include(const std::string& name, const std::string& from, std::size_t depth);

  Files& files_;
  std::string refused_;
  std::vector<std::string> missing_;
  std::size_t count_ = 0;
};

// Macros that #if, #ifdef or #ifndef of these files ask for and that nothing defines, in alphabetical order,
// without those of the compiler itself.
std::vector<std::string> asked_macros(const Files& files, const Source& source);
// Macros of the command line whose names stand in none of them.
std::vector<std::string> unmentioned_macros(const Files& files, const Source& source);

}  // namespace brdf::shader
