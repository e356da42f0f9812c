// A shader's file: its text, and what its comments and blocks say of parameters and of the function.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/parameter.h"
#include "shader/front/languages.h"

namespace brdf::shader {

// What the function returns; cosines are those to the light and to the viewer.
enum class Returns { f, f_cos_i, f_cos_o };

// What is said of a parameter; what is not said stays open.
struct Declared {
  std::string name;
  std::optional<double> min = {}, max = {};
  std::vector<double> initial = {};  // one, or three of a colour
  bool log_scale = false;
  Role role = Role::other;
  std::uint32_t line = 0;  // 0: the command line
  bool boolean = false;    // 0 or 1
};

// What the author knows that the function violates, for one of the checks of `brdf validate`.
struct KnownViolation {
  std::string check, statement;
  double theta = 0;  // degrees: where it shows at the latest
  std::uint32_t line = 0;
};

struct EntryLine {
  std::string name;
  std::optional<std::vector<std::string>> arguments = {};  // the names that their roles are read from
};

struct Source {
  std::string name;              // of the file, for messages
  std::filesystem::path folder;  // includes stay within
  std::string text;              // lines as in the file
  std::string bare =
      {};  // the same without comments and what stands in quotes: all that is guessed is guessed from this
  std::string whole = {};  // with its includes, macros replaced: once it was compiled
  Language language = Language::glsl;
  std::vector<Declared> parameters = {};
  std::vector<std::string> globals =
      {};  // parameters that the text declares as globals: those of a .brdf file
  std::vector<KnownViolation> violations = {};
  std::optional<EntryLine> entry = {};
  std::optional<Returns> returns = {};
  std::vector<std::string> defines = {};          // NAME=VALUE, as the command line has them
  std::vector<std::string> include_folders = {};  // of the command line, after the file's own
  bool explorer = false;                          // a .brdf file
  bool compute = false;                           // of a compute shader
};

constexpr std::size_t kLargestShader = 1u << 18;

// Throws InputError where the file cannot be read, is too large or nested too deeply, or a `//:` line or a
// block is not understood.
Source read_source(const std::filesystem::path& path);
// The same of a text under that name; HLSL is told by its words (float3, cbuffer), else by the name's end
// (.hlsl, .hlsli, .fx, .usf); a text with ::begin is a .brdf file. Of a script that holds shaders in
// backticks, and of Unity's ShaderLab, both told by their suffixes, the shaders alone are read.
Source parse_source(std::string name, std::string text, std::filesystem::path folder = {});

// "NAME=MIN:MAX" or "NAME=MIN:MAX:DEFAULT", with ":log" after it; as the command line has it.
Declared parse_parameter(const std::string& text);
// "NAME" or "NAME(L, V, N)".
EntryLine parse_entry(const std::string& text);
Returns parse_returns(const std::string& text);

// The line, trimmed; empty beyond the last.
std::string line_of_text(std::string_view text, std::uint32_t line);

}  // namespace brdf::shader

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 3> kNames<shader::Returns>{"f", "f*cos_i", "f*cos_o"};

}  // namespace brdf
