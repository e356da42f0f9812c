#include "prove/check/certificate.h"

#include <algorithm>

#include "io/files/digest.h"
#include "io/files/fingerprint.h"
#include "prove/check/rows.h"

namespace brdf::prove {
namespace {

using io::Json;
using io::JsonPlace;

constexpr std::string_view kFormat = "brdf-proof";
constexpr int kVersion = 2;

// Returns the seal of the exact bytes, without the digits of the seal itself. Even a digit that changes no
// number counts as a change.
std::string seal_of(std::string_view text, std::string_view seal) {
  const std::size_t at = text.find("\"seal\""), from = at == text.npos ? at : text.find(seal, at);
  if (from == text.npos) return "";
  std::string rest(text.substr(0, from));
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  rest += text.substr(from + seal.size(), last + 1 - from - seal.size());
  return io::sha256(rest);
}

// Returns the seal of version 1: a checksum from the results on.
std::string seal_of_first(std::string_view text) {
  const std::size_t from = text.find("\"results\""), last = text.find_last_not_of(" \t\r\n");
  return from == text.npos ? "" : io::fingerprint({text.substr(from, last + 1 - from)});
}

// Version 1 had no materials, and called the scalar of a property that holds in any precision "double".
void bring_up_to_date(Json& certificate) {
  certificate["materials"] = Json::array();
  for (Json& row : certificate["results"]) {
    if (!row.is_object() || !row.contains("property") || !row["property"].is_string()) continue;
    const std::string property = row["property"].get<std::string>();
    const auto known = find_named<Property>(property);
    const bool any = property == kGrowth || (known && !is_of_a_precision(*known));
    if (any && row.value("scalar", Json()) == "double") row["scalar"] = "any";
  }
}

// Returns whether the certificate has version 1.
bool check_header(const JsonPlace& root) {
  if (!root.value().is_object()) root.fail("must be an object");
  if (root.at("format").text() != kFormat) root.at("format").fail("must be " + std::string(kFormat));
  const double version = root.at("version").number();
  if (version != 1 && version != kVersion)
    root.at("version").fail("must be 1 or " + std::to_string(kVersion));
  root.at("results").size();
  if (version == 1)
    root.allow_keys({"format", "version", "seal", "results"});
  else
    root.allow_keys({"format", "version", "seal", "results", "materials"});
  return version == 1;
}

std::vector<NamedMaterial> read_materials(const JsonPlace& place) {
  std::vector<NamedMaterial> materials;
  for (std::size_t k = 0; k < place.size(); ++k) {
    const JsonPlace one = place.at(k), material = one.at("material");
    one.allow_keys({"file", "material"});
    const std::string file = one.at("file").text();
    if (std::ranges::find(materials, file, &NamedMaterial::file) != materials.end())
      one.at("file").fail("is named twice");
    materials.push_back({file, io::material_from_json(material).material});
    if (io::to_json(materials.back().material) != material.value())
      material.fail("must contain only the keys that determine a material's reflectance");
  }
  return materials;
}

std::string label(const CheckedResult& r) {
  return r.subject + (r.channel.empty() ? "" : " " + r.channel) + ", " + r.property;
}

}  // namespace

Json ranges_of(const Domain& domain) {
  Json json = Json::object();
  for (const Variable& v : domain.variables) json[v.name] = Json::array({v.low, v.high});
  return json;
}

std::string sealed(const Json& results, const Json& materials) {
  Json json;
  json["format"] = kFormat;
  json["version"] = kVersion;
  json["seal"] = "";
  json["results"] = results;
  json["materials"] = materials;
  json["seal"] = io::sha256(io::to_line(json));
  return io::to_line(json) + "\n";
}

Checked check(const io::Content& content) {
  Json certificate = io::read_json(content);
  const JsonPlace root(certificate, content.name);
  const bool first = check_header(root);
  const std::string seal = root.at("seal").text();
  Checked checked;
  if (seal.empty() || seal != (first ? seal_of_first(content.bytes) : seal_of(content.bytes, seal))) {
    checked.faults.push_back("the seal does not match the certificate: the certificate was changed");
    return checked;
  }
  if (first) bring_up_to_date(certificate);
  const JsonPlace results = root.at("results");
  checked.materials = read_materials(root.at("materials"));
  for (std::size_t k = 0; k < results.size(); ++k) {
    const JsonPlace row = results.at(k);
    checked.results.push_back(row.has("material") ? check_material_row(row, checked.materials, checked.leaves)
                                                  : check_form_row(row, checked.leaves));
    const CheckedResult& r = checked.results.back();
    if (!r.fault.empty())
      checked.faults.push_back(label(r) + ", " + row.at("scalar").text() + ": " + r.fault);
  }
  return checked;
}

}  // namespace brdf::prove
