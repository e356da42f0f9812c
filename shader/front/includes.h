// Manages the files that a shader's text consists of: its own file and the files that it includes.
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
  std::string shown;       // its name in messages
  std::string text, bare;  // as in Source; a definition that is left out is removed from both
};

// All files that were read so far. Each included file is read once, so that a definition that was left out
// stays left out.
class Files {
 public:
  // The source must outlive this object. Folders that do not exist are ignored.
  explicit Files(const Source& source);

  // Returns the file with this path ("" is the shader's own file); null if no such file was read.
  const IncludedFile* find(const std::string& path) const;
  const IncludedFile& own() const { return files_.at(""); }
  const std::map<std::string, IncludedFile>& all() const { return files_; }
  void leave_out(const std::string& path, const Definition& definition);

  // Returns the file for an #include of `name` in the file `from`, and sets `path`. The file must be below
  // the shader's own folder or below a folder of -I after links are resolved. Returns null if there is no
  // such file. Throws InputError if the file cannot be read.
  const IncludedFile* include(const std::filesystem::path& name, const std::filesystem::path& from,
                              std::string& path);

 private:
  std::optional<std::filesystem::path> inside(const std::filesystem::path& path) const;
  std::optional<std::filesystem::path> look_up(const std::filesystem::path& name,
                                               const std::filesystem::path& from) const;

  const Source& source_;
  std::vector<std::filesystem::path> folders_;  // the shader's own folder first
  std::map<std::string, IncludedFile> files_;
};

// Serves the compiler's include requests while it reads a text once. A missing file is treated as empty,
// because the function may not need its content.
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
  // Returns the reason why reading stopped; empty if the text was read completely.
  const std::string& refused() const { return refused_; }
  // Returns the included names without a file, in quotes.
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  IncludeResult* include(const std::string& name, const std::string& from, std::size_t depth);

  Files& files_;
  std::string refused_;
  std::vector<std::string> missing_;
  std::size_t count_ = 0;
};

// Returns the macros that #if, #ifdef or #ifndef of these files test but nothing defines, in alphabetical
// order, without the macros of the compiler itself.
std::vector<std::string> asked_macros(const Files& files, const Source& source);
// Returns the macros of the command line that are not mentioned in any of these files.
std::vector<std::string> unmentioned_macros(const Files& files, const Source& source);

}  // namespace brdf::shader
