// Writes proofs as certificates.
#include <algorithm>

#include "prove/check/certificate.h"
#include "prove/check/channel.h"
#include "prove/energy/growth.h"
#include "prove/report.h"

namespace brdf::prove {
namespace {

using io::Json;

// Returns a cover as a tree. A leaf of an albedo's cover has the accuracy of its cells after its bounds.
Json tree(const Domain& domain, const Cover& cover, bool of_albedo = false) {
  Json json = Json::array();
  for (const Cover::Node& n : cover.nodes) {
    json.push_back(n.variable < 0 ? Json::array({n.bounds.lo, n.bounds.hi})
                                  : Json::array({domain.variables[std::size_t(n.variable)].name, n.cut}));
    if (of_albedo && n.variable < 0) json.back().push_back(n.accuracy);
  }
  return json;
}

Json growth_row(const Proof& p) {
  const Domain& domain = growth_method(p.claim.form)->domain;
  return {
      {"form", p.form},           {"property", kGrowth},         {"scalar", scalar_of(p.claim)},
      {"arithmetic", kExact},     {"low", p.growth->low},        {"high", p.growth->high},
      {"width", p.growth->width}, {"domain", ranges_of(domain)}, {"cover", tree(domain, p.growth->cover)}};
}

bool is_closed(const Proof& p) {
  return p.domain && !p.cover.nodes.empty() && p.cover.open == 0;
}

void add_cover(Json& row, const Proof& p) {
  row["low"] = p.cover.range.lo;
  row["high"] = p.cover.range.hi;
  row["domain"] = ranges_of(*p.domain);
  row["cover"] = tree(*p.domain, p.cover);
}

void add_angles(Json& row, const Witness& witness) {
  for (const auto& [name, value] : witness.angles) row["witness"][name] = value;
}

Json start_of(const Proof& p) {
  Json row;
  if (p.material.empty()) {
    row["form"] = p.form;
  } else {
    row["material"] = p.material;
    if (!p.channel.empty()) row["channel"] = p.channel;
  }
  row["property"] = name_of(p.claim.property);
  row["scalar"] = scalar_of(p.claim);
  row["arithmetic"] = p.arithmetic;
  return row;
}

// Returns null if the proof has nothing that a check could repeat.
Json row_of_form(const Proof& p) {
  const bool reciprocal = p.claim.property == Property::reciprocity && p.verdict == Verdict::proved;
  const bool refuted = p.verdict == Verdict::refuted && p.witness && p.witness->violation >= 0;
  if (!reciprocal && !refuted && !is_closed(p)) return nullptr;
  Json row = start_of(p);
  if (is_closed(p)) add_cover(row, p);
  if (refuted) {
    row["witness"] = {{"violation", p.witness->violation}};
    add_angles(row, *p.witness);
  }
  return row;
}

void add_albedo(Json& row, const Proof& p) {
  row["low"] = p.low;
  row["low_at"] = Json::array({p.low_at->turn.lo});
  if (p.domain->variables.size() > 1) row["low_at"].push_back(p.low_at->azimuth.lo);
  row["high"] = p.cover.range.hi;
  row["domain"] = ranges_of(*p.domain);
  row["cover"] = tree(*p.domain, p.cover, true);
}

Json row_of_material(const Proof& p) {
  Json row = start_of(p);
  if (p.claim.property == Property::energy) {
    if (p.low_at) add_albedo(row, p);
    if (p.witness) add_angles(row, *p.witness);
    return p.low_at || p.witness ? row : Json(nullptr);
  }
  if (p.verdict != Verdict::proved) return nullptr;
  if (p.claim.property == Property::reciprocity) return row;
  row["terms"] = Json::array();
  for (const Proof& term : p.terms) {
    row["terms"].push_back(Json::object());
    add_cover(row["terms"].back(), term);
  }
  return row;
}

}  // namespace

std::string to_certificate(std::span<const Proof> proofs, std::span<const NamedMaterial> materials) {
  Json results = Json::array(), of_materials = Json::array();
  for (const NamedMaterial& m : materials)
    of_materials.push_back({{"file", m.file}, {"material", io::to_json(m.material)}});
  for (const Proof& p : proofs) {
    if (p.growth) results.push_back(growth_row(p));
    Json row = p.material.empty() ? row_of_form(p) : row_of_material(p);
    if (!row.is_null()) results.push_back(std::move(row));
  }
  return sealed(results, of_materials);
}

}  // namespace brdf::prove
