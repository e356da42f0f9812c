#include "io/columns/foreign_json.h"

#include <algorithm>
#include <vector>

#include "io/columns/column_names.h"

namespace brdf::io {
namespace {

// Returns the keys of a JSON text at any depth, in order, at most kMost. A quoted string counts as a key if
// a colon follows.
std::vector<std::string_view> keys_of(std::string_view json) {
  constexpr std::size_t kMost = 4000;
  std::vector<std::string_view> keys;
  for (std::size_t at = json.find('"'); at != json.npos && keys.size() < kMost; at = json.find('"', at + 1)) {
    std::size_t end = at + 1;
    while (end < json.size() && json[end] != '"') end += json[end] == '\\' ? 2 : 1;
    if (end >= json.size()) break;
    const std::size_t next = json.find_first_not_of(" \t\r\n", end + 1);
    if (next != json.npos && json[next] == ':') keys.push_back(json.substr(at + 1, end - at - 1));
    at = end;
  }
  return keys;
}

}  // namespace

JsonTable json_table(const Content& content) {
  const std::vector<std::string_view> keys = keys_of(content.bytes);
  const auto has = [&](std::string_view key) { return std::ranges::find(keys, key) != keys.end(); };
  if (has("reflectionCoefficient") || has("reflectionCoefficients")) return JsonTable::openmaterial_ratios;
  if (has("lookupTable") && has("brdf")) return JsonTable::openmaterial;
  if (has("openMaterial3dVersion")) return JsonTable::openmaterial_material;
  if (has("BRDF") && has("theta_i") && has("theta_r")) return JsonTable::bird;
  if (has("theta_i") && has("theta_v") && has("phi_v")) return JsonTable::early_bird;
  return names_angles({keys.begin(), keys.end()}) ? JsonTable::unknown : JsonTable::absent;
}

namespace {

// Returns whether a string begins with this word. A quotation mark behind a backslash belongs to a string,
// such as the material of a synthetic table in a comment.
bool has_string(std::string_view json, std::string_view begin) {
  const std::string quoted = "\"" + std::string(begin);
  for (std::size_t at = json.find(quoted); at != json.npos; at = json.find(quoted, at + 1))
    if (at == 0 || json[at - 1] != '\\') return true;
  return false;
}

}  // namespace

bool may_be_material(const Content& content) {
  if (!is_json(content)) return false;
  // Texts that begin with a brace although they are not JSON: RTF, and functions behind a comment in braces.
  const std::size_t end = content.bytes.find('}');
  if (content.bytes.starts_with("{\\rtf") || (end != std::string::npos && content.bytes.find('"') > end &&
                                              content.bytes.find('=', end) != std::string::npos))
    return false;
  // Materials of this project have the key "format" and may hold any keys in their statistics.
  return has_string(content.bytes, "brdf-") || json_table(content) == JsonTable::absent;
}

std::string foreign_json(const Content& content) {
  const std::string unread = std::string(", which is not read: ") + std::string(kExportAsCsv);
  const std::string samples = ", which holds samples: `brdf fit` finds a material for them";
  const std::string json = "is JSON, but not a material: the content looks like ";
  switch (json_table(content)) {
    case JsonTable::openmaterial:
      return json + "a look-up table of ASAM OpenMATERIAL" + samples;
    case JsonTable::openmaterial_ratios:
      return json +
             "a table of ASAM OpenMATERIAL with ratios of amplitudes (*_reflCoeff.xompt), which lacks the "
             "solid angles that f_r needs: use the file *_brdf.xompt of the material";
    case JsonTable::openmaterial_material:
      return json +
             "a file of ASAM OpenMATERIAL without a BRDF look-up table: use the file *_brdf.xompt of the "
             "material";
    case JsonTable::bird:
      return json + "a universal BRDF file (BiRD)" + samples;
    case JsonTable::early_bird:
      return json + "a BRDF file of BiRD before version 1.0" + samples;
    case JsonTable::unknown:
      return json + "a table of samples of another program" + unread;
    case JsonTable::absent:
      break;
  }
  return "";
}

}  // namespace brdf::io
