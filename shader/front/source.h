// Reads a shader's file: its text, and the declarations in its comments and blocks about parameters and the
// function.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/direction_sampler.h"
#include "brdf/parameter.h"
#include "shader/front/languages.h"
#include "shader/front/texture.h"

namespace brdf::shader {

// The quantity that the function returns; cos_i is the cosine to the light, cos_o the cosine to the viewer.
enum class Returns { f, f_cos_i, f_cos_o };

// A parameter's declaration. Members without a value are not declared.
struct Declared {
  std::string name;
  std::optional<double> min = {}, max = {};
  std::vector<double> initial = {};  // one number, or three for a colour
  bool log_scale = false;
  Role role = Role::other;
  std::uint32_t line = 0;  // 0: the command line
  bool boolean = false;    // 0 or 1
};

// A violation that the author declares, for one of the checks of `brdf validate`.
struct KnownViolation {
  std::string check, statement;
  double theta = 0;  // degrees: the violation occurs at this angle at the latest
  double most = 0;   // the value of the check that is known, 0: not stated
  std::uint32_t line = 0;
};

struct EntryLine {
  std::string name;
  std::optional<std::vector<std::string>> arguments = {};  // names that determine the arguments' roles
};

struct Source {
  std::string name;              // of the file, for messages
  std::filesystem::path folder;  // includes must be inside
  std::string text;              // the same lines as in the file
  // The text without comments and the contents of quotes. All guesses are based on this text.
  std::string bare = {};
  std::string whole = {};                  // with its includes, macros replaced; set after compilation
  std::vector<std::uint32_t> module = {};  // the words of a SPIR-V file, which has no text
  Language language = Language::glsl;
  std::vector<Declared> parameters = {};
  // Parameters that the text declares as globals, in a .brdf file.
  std::vector<std::string> globals = {};
  std::vector<KnownViolation> violations = {};
  std::optional<EntryLine> entry = {};
  std::optional<Returns> returns = {};
  // The sampler and the density of the file, the quantity that the sampler returns, and the measure of the
  // density; without a value: according to names and values.
  std::optional<EntryLine> sample = {}, pdf = {};
  std::optional<SampleValue> sample_returns = {};
  std::optional<DensityOf> density_of = {};
  std::vector<std::string> defines = {};          // NAME=VALUE, from the command line
  std::vector<std::string> include_folders = {};  // from the command line, searched after the file's folder
  std::vector<TextureChoice> textures = {};       // from the command line
  bool shares_textures = false;                   // some of them may belong to other shaders
  bool explorer = false;                          // a .brdf file
  bool compute = false;                           // a compute shader
};

constexpr std::size_t kLargestShader = 1u << 18;

// Reads a shader's file: a text, or a SPIR-V module (front/module_file.h). Throws InputError if the file
// cannot be read, is too large or nested too deeply, or if a `//:` line or a block cannot be parsed.
Source read_source(const std::filesystem::path& path);
// Reads a shader from the content of a file, a text or a module, with `name` as its file name. HLSL is
// detected from its words (float3, cbuffer), otherwise from the suffix of the name (.hlsl, .hlsli, .fx,
// .fxh, .usf, .ush, .cginc). A text with ::begin is a .brdf file. In a script with shaders in backticks, and
// in Unity's ShaderLab, both detected from their suffixes, only the shaders are read. Throws InputError like
// read_source().
Source parse_source(std::string name, std::string text, std::filesystem::path folder = {});

// Parses "NAME=MIN:MAX" or "NAME=MIN:MAX:DEFAULT", with an optional ":log", from the command line. Throws
// InputError if the text is not valid.
Declared parse_parameter(const std::string& text);
// Parses "NAME" or "NAME(L, V, N)". Throws InputError if the text is not valid.
EntryLine parse_entry(const std::string& text);
// Parses "f", "f*cos_i" or "f*cos_o". Throws InputError if the text is not valid.
Returns parse_returns(const std::string& text);
// Parses "f", "f*cos_i" or "f*cos_i/pdf"; and "solid_angle", "projected" or "half". Throws InputError if the
// text is not valid.
SampleValue parse_sample_value(const std::string& text);
DensityOf parse_density_of(const std::string& text);

// Returns the line with this number, trimmed; empty beyond the last line.
std::string line_of_text(std::string_view text, std::uint32_t line);

}  // namespace brdf::shader

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 3> kNames<shader::Returns>{"f", "f*cos_i", "f*cos_o"};

}  // namespace brdf
