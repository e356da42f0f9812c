#include "prove/check/certificate.h"

#include <functional>
#include <span>

#include "brdf/reflectance.h"
#include "io/error.h"
#include "io/fingerprint.h"
#include "prove/scalar/claim.h"
#include "prove/scalar/growth.h"
#include "prove/scalar/swapped.h"

namespace brdf::prove {
namespace {

using io::Json;
using io::JsonPlace;

constexpr std::string_view kFormat = "brdf-proof";
constexpr int kVersion = 1;
constexpr int kDeepest = 4000;

template <class Enum>
Enum named(const JsonPlace& place) {
  const auto found = find_named<Enum>(place.text());
  if (!found) place.fail("must be one of " + known_names<Enum>());
  return *found;
}

// Walks a cover from its root: every leaf's box follows from the cuts above it, so that nothing is left out.
struct Walk {
  std::function<Bounds(std::span<const Bounds>)> enclose;
  std::function<bool(Bounds)> settles;
  const Domain& domain;
  const JsonPlace& cover;
  std::vector<Bounds> box{};
  std::size_t at = 0;
  long leaves = 0;
  Bounds range{};
  std::string fault{};

  bool bad(const std::string& what) {
    if (fault.empty()) fault = what;
    return false;
  }

  bool leaf(const JsonPlace& node) {
    const Bounds stated{node.at(std::size_t(0)).number(), node.at(1).number()};
    const Bounds found = enclose(box);
    range = leaves == 0 ? found : Bounds{std::min(range.lo, found.lo), std::max(range.hi, found.hi)};
    ++leaves;
    if (!settles(found)) return bad("leaf " + std::to_string(leaves) + " does not settle it");
    if (found.lo != stated.lo || found.hi != stated.hi)
      return bad("leaf " + std::to_string(leaves) + " has other bounds");
    return true;
  }

  bool visit(int depth) {
    if (at >= cover.size()) return bad("the cover ends early");
    if (depth > kDeepest) return bad("the cover is too deep");
    const JsonPlace node = cover.at(at++);
    if (node.size() != 2) node.fail("must have two members");
    if (!node.at(std::size_t(0)).value().is_string()) return leaf(node);
    const std::string name = node.at(std::size_t(0)).text();
    for (std::size_t k = 0; k < box.size(); ++k) {
      if (domain.variables[k].name != name) continue;
      const double cut = node.at(1).number();
      const Bounds whole = box[k];
      if (!(whole.lo < cut && cut < whole.hi)) return bad("a cut lies outside its box");
      box[k] = {whole.lo, cut};
      if (!visit(depth + 1)) return false;
      box[k] = {cut, whole.hi};
      if (!visit(depth + 1)) return false;
      box[k] = whole;
      return true;
    }
    return bad("a cut of " + name + ", which the domain does not have");
  }

  bool run() {
    for (const Variable& v : domain.variables) box.push_back({v.low, v.high});
    return visit(0) && (at == cover.size() || bad("the cover goes on after its last leaf"));
  }
};

std::string other_domain(const Domain& domain, const JsonPlace& row) {
  const std::string fault = "has another domain";
  const JsonPlace stated = row.at("domain");
  if (stated.value().size() != domain.variables.size()) return fault;
  for (const Variable& v : domain.variables) {
    if (!stated.has(v.name)) return fault;
    const JsonPlace range = stated.at(v.name);
    if (range.at(std::size_t(0)).number() != v.low || range.at(1).number() != v.high) return fault;
  }
  return "";
}

std::string covers(const Claim& claim, const JsonPlace& row, long& leaves) {
  const auto domain = domain_of(claim);
  if (!domain) return "is not shown by boxes";
  if (const std::string fault = other_domain(*domain, row); !fault.empty()) return fault;
  const JsonPlace cover = row.at("cover");
  const double low = row.at("low").number(), high = row.at("high").number();
  Walk walk{[&](std::span<const Bounds> box) { return enclose(claim, box); },
            [&](Bounds b) { return settles(claim.property, b, high); }, *domain, cover};
  const bool good = walk.run();
  leaves += walk.leaves;
  if (!good) return walk.fault;
  if (walk.range.lo != low || walk.range.hi != high) return "low and high are not those of the leaves";
  return "";
}

// Of the growth of an albedo: `high` over all widths and cosines by the cover, `low` at one width.
std::string grows(int form, const JsonPlace& row, long& leaves) {
  const GrowthMethod* method = growth_method(form);
  if (method == nullptr) return "is not known to grow";
  if (const std::string fault = other_domain(method->domain, row); !fault.empty()) return fault;
  const JsonPlace cover = row.at("cover");
  const double high = row.at("high").number(), width = row.at("width").number();
  Walk walk{method->most, [&](Bounds b) { return b.hi <= high; }, method->domain, cover};
  const bool good = walk.run();
  leaves += walk.leaves;
  if (!good) return walk.fault;
  if (walk.range.hi != high) return "high is not that of the leaves";
  const Variable& widths = method->domain.variables[0];
  if (!(widths.low <= width && width <= widths.high)) return "its width is none of the form's";
  if (reached_at(*method, width).least != row.at("low").number())
    return "low is not what is reached at its width";
  return "";
}

std::string fault_of(const JsonPlace& row, long& leaves) {
  const auto form = find_form(row.at("form").text());
  if (!form) row.at("form").fail("is no form of the catalogue");
  if (row.at("property").text() == "growth") return grows(catalogue_index(*form), row, leaves);
  const Claim claim{catalogue_index(*form), named<Property>(row.at("property")),
                    named<Precision>(row.at("scalar"))};
  if (claim.property != Property::reciprocity) return covers(claim, row, leaves);
  const bool exact = row.at("arithmetic").text() == "exact";
  return record_both_orders(claim.form, exact ? Rules::exact : Rules::bits).same ? "" : "both orders differ";
}

// Of the bytes as they stand: a digit that changes no number is one that was changed.
std::string seal_of(std::string_view text) {
  const std::size_t from = text.find("\"results\""), last = text.find_last_not_of(" \t\r\n");
  return from == text.npos ? "" : io::fingerprint({text.substr(from, last + 1 - from)});
}

}  // namespace

std::string sealed(const Json& results) {
  Json json;
  json["format"] = kFormat;
  json["version"] = kVersion;
  json["seal"] = "";
  json["results"] = results;
  json["seal"] = seal_of(io::to_line(json));
  return io::to_line(json) + "\n";
}

Checked check(const io::Content& content) {
  const Json certificate = io::read_json(content);
  const JsonPlace root(certificate, content.name);
  root.allow_keys({"format", "version", "seal", "results"});
  if (root.at("format").text() != kFormat) root.at("format").fail("must be " + std::string(kFormat));
  if (root.at("version").number() != kVersion) root.at("version").fail("must be " + std::to_string(kVersion));
  const JsonPlace results = root.at("results");
  Checked checked;
  if (root.at("seal").text() != seal_of(content.bytes)) {
    checked.faults.push_back("the seal is not that of the results: something was changed");
    return checked;
  }
  for (std::size_t k = 0; k < results.size(); ++k) {
    const JsonPlace row = results.at(k);
    row.allow_keys({"form", "property", "scalar", "arithmetic", "low", "high", "width", "domain", "cover"});
    const std::string fault = fault_of(row, checked.leaves);
    ++checked.results;
    if (!fault.empty())
      checked.faults.push_back(row.at("form").text() + ", " + row.at("property").text() + ", " +
                               row.at("scalar").text() + ": " + fault);
  }
  return checked;
}

}  // namespace brdf::prove
