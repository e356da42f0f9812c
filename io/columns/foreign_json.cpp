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

std::string foreign_json(const Content& content) {
  const std::vector<std::string_view> keys = keys_of(content.bytes);
  const auto has = [&](std::string_view key) { return std::ranges::find(keys, key) != keys.end(); };
  const std::string end = std::string(", which is not read: ") + std::string(kExportAsCsv);
  const std::string json = "is JSON, but not a material: the content looks like ";
  if (has("lookupTable"))
    return json +
           "a look-up table of ASAM OpenMATERIAL (wavelength in m, theta_i, theta_o, phi_o in radians, "
           "value)" +
           end;
  if (has("reflectionCoefficients") || (has("lookupTable") && has("polarization")))
    return json + "amplitude ratios" + end;
  if (has("BRDF") && has("theta_i") && has("theta_r")) return json + "a universal BRDF file (BiRD)" + end;
  if (has("theta_i") && has("theta_v") && has("phi_v"))
    return json + "a BRDF file of BiRD before version 1.0" + end;
  if (names_angles({keys.begin(), keys.end()})) return json + "a table of samples of another program" + end;
  return "";
}

}  // namespace brdf::io
