#include "prove/report.h"

#include <iomanip>

#include "io/numbers.h"
#include "io/text.h"
#include "prove/check/certificate.h"
#include "prove/scalar/growth.h"

namespace brdf::prove {
namespace {

using io::Json;

Json range(const Domain& domain) {
  Json json = Json::object();
  for (const Variable& v : domain.variables) json[v.name] = Json::array({v.low, v.high});
  return json;
}
Json box(const Domain& domain, const Box& b) {
  Json json = Json::object();
  for (std::size_t k = 0; k < b.size(); ++k) json[domain.variables[k].name] = Json::array({b[k].lo, b[k].hi});
  return json;
}
Json pairs(const std::vector<std::pair<std::string, double>>& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) json[name] = value;
  return json;
}
Json finite_or_null(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}
Json rounding(const LobeRounding& lobe) {
  return {
      {"error", finite_or_null(lobe.error)}, {"beside", name_of(lobe.beside)}, {"underflow", lobe.underflow}};
}

// What is shown of the formula itself holds in any precision.
std::string_view scalar_of(const Claim& claim) {
  return is_of_a_precision(claim.property) ? name_of(claim.precision) : "any";
}

// Whether low and high say anything.
bool has_range(const Proof& p) {
  if (p.verdict == Verdict::no_method) return false;
  if (p.claim.property == Property::rounding) return p.verdict == Verdict::proved;
  return p.domain.has_value() || p.verdict == Verdict::refuted;
}

Json tree(const Domain& domain, const Cover& cover) {
  Json json = Json::array();
  for (const Cover::Node& n : cover.nodes)
    json.push_back(n.variable < 0 ? Json::array({n.bounds.lo, n.bounds.hi})
                                  : Json::array({domain.variables[std::size_t(n.variable)].name, n.cut}));
  return json;
}

Json growth_row(const Proof& p) {
  const Domain& domain = growth_method(p.claim.form)->domain;
  return {{"form", p.form},           {"property", "growth"},    {"scalar", name_of(p.claim.precision)},
          {"arithmetic", "exact"},    {"low", p.growth->low},    {"high", p.growth->high},
          {"width", p.growth->width}, {"domain", range(domain)}, {"cover", tree(domain, p.growth->cover)}};
}

}  // namespace

void print(std::ostream& out, std::span<const Proof> proofs) {
  out << std::left << std::setw(28) << "form" << std::setw(14) << "property" << std::setw(8) << "scalar"
      << std::setw(11) << "verdict" << std::setw(26) << "low .. high" << std::right << std::setw(8) << "boxes"
      << std::setw(10) << "seconds"
      << "  statement\n";
  for (const Proof& p : proofs) {
    const std::string bounds =
        has_range(p) ? io::short_number(p.low, 6) + " .. " + io::short_number(p.high, 6) : std::string("-");
    out << std::left << std::setw(28) << io::printable(p.channel.empty() ? p.form : p.form + " " + p.channel)
        << std::setw(14) << name_of(p.claim.property) << std::setw(8) << scalar_of(p.claim) << std::setw(11)
        << name_of(p.verdict) << std::setw(26) << bounds << std::right << std::setw(8) << p.cover.boxes
        << std::setw(10) << std::fixed << std::setprecision(3) << p.seconds << std::defaultfloat
        << std::setprecision(6) << "  " << p.statement << '\n';
    if (p.witness)
      out << "    " << io::printable(p.witness->command) << "    gives "
          << io::short_number(p.witness->value, 6) << '\n';
  }
}

Json to_json(std::span<const Proof> proofs) {
  Json json = io::to_json(io::provenance());
  json["results"] = Json::array();
  for (const Proof& p : proofs) {
    Json row;
    row["form"] = p.form;
    if (!p.material.empty()) row["material"] = p.material;
    if (!p.channel.empty()) row["channel"] = p.channel;
    row["property"] = name_of(p.claim.property);
    row["scalar"] = scalar_of(p.claim);
    row["verdict"] = name_of(p.verdict);
    row["arithmetic"] = p.arithmetic;
    row["statement"] = p.statement;
    row["low"] = has_range(p) ? finite_or_null(p.low) : Json(nullptr);
    row["high"] = has_range(p) ? finite_or_null(p.high) : Json(nullptr);
    row["domain"] = p.domain ? range(*p.domain) : Json::object();
    row["boxes"] = p.cover.boxes;
    row["open"] = p.cover.open;
    row["open_boxes"] = Json::array();
    for (const Box& b : p.cover.left) row["open_boxes"].push_back(box(*p.domain, b));
    if (p.claim.property == Property::rounding) {
      row["lobes"] = Json::array();
      for (const LobeRounding& lobe : p.lobes) row["lobes"].push_back(rounding(lobe));
    }
    if (p.growth)
      row["growth"] = {{"power", p.growth->power},
                       {"from", p.growth->from},
                       {"low", p.growth->low},
                       {"high", p.growth->high}};
    row["seconds"] = p.seconds;
    if (p.witness)
      row["witness"] = {{"parameters", pairs(p.witness->parameters)},
                        {"angles", pairs(p.witness->angles)},
                        {"value", p.witness->value},
                        {"command", p.witness->command}};
    else
      row["witness"] = nullptr;
    json["results"].push_back(std::move(row));
  }
  return json;
}

std::string to_certificate(std::span<const Proof> proofs) {
  Json results = Json::array();
  for (const Proof& p : proofs) {
    if (p.growth) results.push_back(growth_row(p));
    const bool closed = p.domain && p.cover.open == 0;  // of a refuted energy: the bound above its witness
    if (p.verdict != Verdict::proved && !closed) continue;
    Json row;
    row["form"] = p.form;
    row["property"] = name_of(p.claim.property);
    row["scalar"] = name_of(p.claim.precision);
    row["arithmetic"] = p.arithmetic;
    if (p.domain) {
      row["low"] = p.cover.range.lo;
      row["high"] = p.cover.range.hi;
      row["domain"] = range(*p.domain);
      row["cover"] = tree(*p.domain, p.cover);
    }
    results.push_back(std::move(row));
  }
  return sealed(results);
}

}  // namespace brdf::prove
