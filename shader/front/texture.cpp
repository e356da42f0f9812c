#include "shader/front/texture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "shader/front/definitions.h"
#include "texel/planes.h"

namespace brdf::shader {
namespace {

constexpr std::size_t kMostTexels = std::size_t(1) << 24;

// Takes the last word of "FILE:WORD" if it is the name of a rule.
template <class Rule>
bool take_rule(std::string& file, Rule& rule) {
  const std::size_t colon = file.rfind(':');
  if (colon == file.npos) return false;
  const auto found = find_named<Rule>(file.substr(colon + 1));
  if (!found) return false;
  rule = *found;
  file.resize(colon);
  return true;
}

std::shared_ptr<const TexelTable> table_of(const TextureChoice& choice, const texel::Planes& planes,
                                           const std::string& channel) {
  const std::vector<float>* const values = planes.find(channel);
  if (values == nullptr) return nullptr;
  auto table = std::make_shared<TexelTable>();
  table->values = *values;
  for (std::size_t k = 0; k < values->size(); ++k)
    if (!std::isfinite((*values)[k]))
      throw InputError("--texture " + choice.name + ": " + choice.file + ": channel " + channel +
                       " is not finite at column " + std::to_string(k % planes.width) + ", row " +
                       std::to_string(k / planes.width) + " (counted from 0)");
  const auto [least, most] = std::ranges::minmax_element(*values);
  table->least = *least;
  table->most = *most;
  return table;
}

}  // namespace

TextureChoice parse_texture(const std::string& text) {
  const std::string rule =
      "--texture " + io::shown(text) +
      ": must be NAME=FILE.exr, followed by :nearest or :bilinear, and by :repeat, :clamp "
      "or :mirror, if the defaults (bilinear, repeat) do not fit";
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0) throw InputError(rule);
  TextureChoice out{std::string(io::trimmed(std::string_view(text).substr(0, equals))),
                    text.substr(equals + 1)};
  bool filter = false, wrap = false;
  for (bool more = true; more;) {
    more = (!filter && (filter = take_rule(out.file, out.filter))) ||
           (!wrap && (wrap = take_rule(out.file, out.wrap)));
  }
  if (out.name.empty() || !std::ranges::all_of(out.name, is_word)) throw InputError(rule);
  const std::string suffix = io::lower_case(std::filesystem::path(out.file).extension().string());
  if (suffix == ".png" || suffix == ".jpg" || suffix == ".jpeg" || suffix == ".tga" || suffix == ".hdr")
    throw InputError(
        "--texture " + io::shown(text) +
        ": a texture must be an OpenEXR file (.exr), whose numbers are linear; convert the picture "
        "to OpenEXR");
  if (suffix != ".exr") throw InputError(rule);
  return out;
}

std::string to_text(const TextureChoice& choice) {
  const TextureChoice usual;
  return choice.name + "=" + choice.file +
         (choice.filter == usual.filter ? "" : ":" + std::string(brdf::name_of(choice.filter))) +
         (choice.wrap == usual.wrap ? "" : ":" + std::string(brdf::name_of(choice.wrap)));
}

Texture read_texture(const TextureChoice& choice) {
  const std::string where = "--texture " + choice.name + ": ";
  texel::Planes planes;
  try {
    planes = texel::read_planes(choice.file);
  } catch (const InputError& error) {
    throw InputError(where + error.what());
  }
  if (planes.width * planes.height > kMostTexels)
    throw InputError(where + choice.file + " has more than " + std::to_string(kMostTexels) + " texels");
  Texture out{std::uint32_t(planes.width), std::uint32_t(planes.height)};
  out.filter = choice.filter;
  out.wrap = choice.wrap;
  const std::array<std::string, 4> names{"R", "G", "B", "A"};
  for (std::size_t c = 0; c < 4; ++c) out.channels[c] = table_of(choice, planes, names[c]);
  const auto absent = [](const auto& channel) { return channel == nullptr; };
  if (std::all_of(out.channels.begin(), out.channels.begin() + 3, absent))
    out.channels[0] = out.channels[1] = out.channels[2] = table_of(choice, planes, "Y");
  if (std::ranges::all_of(out.channels, absent))
    throw InputError(where + choice.file +
                     " has no channel R, G, B, A or Y (its channels: " + io::joined(planes.names) + ")");
  return out;
}

}  // namespace brdf::shader
