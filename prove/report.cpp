#include "prove/report.h"

#include <iomanip>

#include "io/files/numbers.h"
#include "io/files/text.h"
#include "prove/check/certificate.h"

namespace brdf::prove {
namespace {

using io::Json;

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
Json rounding(const LobeRounding& lobe) {
  return {{"error", io::finite_or_null(lobe.error)},
          {"beside", name_of(lobe.beside)},
          {"underflow", lobe.underflow}};
}

// Returns whether low and high carry information.
bool has_range(const Proof& p) {
  if (p.verdict == Verdict::no_method) return false;
  if (p.claim.property == Property::rounding) return p.verdict == Verdict::proved;
  return p.domain.has_value() || p.verdict == Verdict::refuted;
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
    out << std::left << std::setw(27) << io::printable(p.channel.empty() ? p.form : p.form + " " + p.channel)
        << ' ' << std::setw(14) << name_of(p.claim.property) << std::setw(8) << scalar_of(p.claim)
        << std::setw(11) << name_of(p.verdict) << std::setw(26) << bounds << std::right << std::setw(8)
        << p.cover.boxes << std::setw(10) << std::fixed << std::setprecision(3) << p.seconds
        << std::defaultfloat << std::setprecision(6) << "  " << p.statement << '\n';
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
    row["low"] = has_range(p) ? io::finite_or_null(p.low) : Json(nullptr);
    row["high"] = has_range(p) ? io::finite_or_null(p.high) : Json(nullptr);
    row["domain"] = p.domain ? ranges_of(*p.domain) : Json::object();
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

}  // namespace brdf::prove
