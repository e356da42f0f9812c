#include "shader/origin.h"

#include <utf8.h>

#include <algorithm>
#include <filesystem>

#include "io/files/content.h"
#include "io/files/digest.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "shader/front/includes.h"
#include "shader/front/module_file.h"
#include "shader/front/stripped.h"

namespace brdf::shader {
namespace {

constexpr int kDeepestPlace = 16;
constexpr std::size_t kLargestWhole = 16 * kLargestShader;

// The name of the file that a line includes; empty if the line has no #include. `bare`: the line without
// comments and without the contents of quotes.
std::string included_name(std::string_view line, std::string_view bare) {
  std::string_view rest = io::trimmed(bare);
  if (!rest.starts_with('#')) return "";
  rest = io::trimmed(rest.substr(1));
  if (!rest.starts_with("include")) return "";
  const std::size_t word = line.find("include"), open = line.find_first_of("\"<", word);
  if (open == line.npos) return "";
  const std::size_t close = line.find(line[open] == '<' ? '>' : '"', open + 1);
  return close == line.npos ? "" : std::string(line.substr(open + 1, close - open - 1));
}

struct Expansion {
  Files& files;
  const std::string& shown;  // the shader's own file, for messages
  std::string out{};

  void add(std::string_view text, const std::string& from, int depth) {
    if (depth > kDeepestPlace || out.size() > kLargestWhole)
      throw InputError(shown + ": its includes are nested too deeply");
    const std::string bare = stripped(text).text;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t stop = std::min(text.find('\n', at), text.size());
      const std::string_view line = text.substr(at, stop - at);
      add_line(line, std::string_view(bare).substr(at, stop - at), from, depth);
      if (stop < text.size()) out += '\n';
      at = stop + 1;
    }
  }

  void add_line(std::string_view line, std::string_view bare, const std::string& from, int depth) {
    const std::string name = included_name(line, bare);
    std::string path;
    const IncludedFile* file = name.empty() ? nullptr : files.include(name, from, path);
    if (file != nullptr) return add(std::string(file->text), path, depth + 1);
    const bool note = depth > 0 && io::trimmed(line).starts_with("//:");
    out += note ? "// included: " : "";
    out += line;
  }
};

std::string digest_of(const TextureChoice& texture) {
  try {
    return io::sha256(io::read_content(texture.file).bytes);
  } catch (const InputError& error) {
    throw InputError("--texture " + texture.name + ": " + error.what());
  }
}

}  // namespace

std::string whole_text(const ShaderChoice& choice) {
  Source source = read_source(choice.file);
  if (!source.module.empty()) return io::read_content(choice.file, kLargestModule).bytes;
  choose(source, choice);
  const std::string text = text_of_bytes(source.name, io::read_content(choice.file, kLargestShader).bytes);
  Files files(source);
  Expansion expansion{files, source.name};
  expansion.add(text, "", 0);
  return std::move(expansion.out);
}

ShaderOrigin origin_of(const ShaderChoice& choice, bool embedded) {
  ShaderOrigin origin{.choice = choice, .relative = std::filesystem::path(choice.file).is_relative()};
  std::string text = whole_text(choice);
  origin.sha256 = io::sha256(text);
  for (const TextureChoice& texture : choice.textures) origin.texture_sha256.push_back(digest_of(texture));
  if (!embedded) return origin;
  if (is_module(text))
    throw InputError("--embed: " + choice.file +
                     " is SPIR-V, which a material cannot contain: leave --embed out, and the material names "
                     "the file");
  if (text.size() > kLargestShader)
    throw InputError("--embed: " + choice.file +
                     " exceeds, with its includes, the largest text in a material (" +
                     std::to_string(kLargestShader) + " bytes)");
  if (!utf8::is_valid(text.begin(), text.end()))
    throw InputError("--embed: " + choice.file + " is not UTF-8, the encoding of materials");
  origin.text = std::move(text);
  origin.choice.include_folders.clear();  // the text contains their content
  return origin;
}

}  // namespace brdf::shader
