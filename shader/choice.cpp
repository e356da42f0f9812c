#include "shader/choice.h"

#include <algorithm>

#include "io/files/error.h"
#include "io/files/shell.h"
#include "io/files/text.h"
#include "shader/front/definitions.h"

namespace brdf::shader {
namespace {

// Turns "NAME", "NAME=" and "NAME=VALUE" into the form NAME=VALUE.
std::string parse_define(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  if (name.empty() || !std::ranges::all_of(name, is_word) || (name[0] >= '0' && name[0] <= '9') ||
      name == "defined" || text.find_first_of("\n\r") != text.npos)
    throw InputError("--define " + io::shown(text) +
                     ": must be NAME, NAME= or NAME=VALUE, with a name of a macro");
  return equals == text.npos ? text + "=1" : text;
}

}  // namespace

void choose(Source& source, const ShaderChoice& choice) {
  if (!choice.entry.empty()) source.entry = parse_entry(choice.entry);
  if (!choice.returns.empty()) source.returns = parse_returns(choice.returns);
  if (!choice.sample.empty()) source.sample = parse_entry(choice.sample);
  if (!choice.pdf.empty()) source.pdf = parse_entry(choice.pdf);
  for (const std::string& text : choice.parameters) source.parameters.push_back(parse_parameter(text));
  for (const std::string& text : choice.defines) {
    const std::string define = parse_define(text), name = define.substr(0, define.find('=') + 1);
    for (const std::string& before : source.defines)
      if (before.starts_with(name) && before != define)
        throw InputError("--define " + io::shown(text) + ": another --define gives " + io::shown(before));
    source.defines.push_back(define);
  }
  for (const std::string& folder : choice.include_folders) {
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error))
      throw InputError("-I " + io::shown(folder) + ": is not a folder");
    source.include_folders.push_back(std::filesystem::absolute(folder).string());
  }
  for (const TextureChoice& texture : choice.textures) {
    if (std::ranges::find(source.textures, texture.name, &TextureChoice::name) != source.textures.end())
      throw InputError("--texture " + io::shown(to_text(texture)) + ": another --texture gives " +
                       texture.name);
    source.textures.push_back(texture);
  }
  source.shares_textures = choice.shares_textures;
}

std::string command_words(const ShaderChoice& choice) {
  std::string words = "--shader " + io::shell_file(choice.file);
  for (const std::string& p : choice.parameters) words += " --param " + io::shell_word(p);
  if (!choice.entry.empty()) words += " --entry " + io::shell_word(choice.entry);
  if (!choice.returns.empty()) words += " --returns " + io::shell_word(choice.returns);
  if (!choice.sample.empty()) words += " --sample " + io::shell_word(choice.sample);
  if (!choice.pdf.empty()) words += " --pdf " + io::shell_word(choice.pdf);
  for (const std::string& d : choice.defines) words += " --define " + io::shell_word(d);
  for (const std::string& folder : choice.include_folders) words += " -I " + io::shell_file(folder);
  for (const TextureChoice& texture : choice.textures)
    words += " --texture " + io::shell_word(to_text(texture));
  return words;
}

}  // namespace brdf::shader
