#include "prove/check/cover_walk.h"

#include <algorithm>
#include <vector>

namespace brdf::prove {
namespace {

using io::JsonPlace;

constexpr int kDeepest = 4000;

struct Walk {
  const WalkedCover& what;
  std::vector<Bounds> box{};
  std::size_t at = 0;
  long leaves = 0;
  Walked found{};

  bool bad(const std::string& fault) {
    if (found.fault.empty()) found.fault = fault;
    return false;
  }

  bool leaf(const JsonPlace& node) {
    const Bounds stated{node.at(std::size_t(0)).number(), node.at(1).number()};
    const auto bounds = what.enclose(box, node);
    ++leaves;
    const std::string name = "leaf " + std::to_string(leaves);
    if (!bounds) return bad(name + " is of an unknown kind");
    found.range = leaves == 1
                      ? *bounds
                      : Bounds{std::min(found.range.lo, bounds->lo), std::max(found.range.hi, bounds->hi)};
    if (!what.settles(*bounds)) return bad(name + " does not decide the claim");
    if (bounds->lo != stated.lo || bounds->hi != stated.hi)
      return bad(name + " states bounds that differ from the recomputed bounds");
    return true;
  }

  bool visit(int depth) {
    if (at >= what.cover.size()) return bad("the cover ends early");
    if (depth > kDeepest) return bad("the cover is too deep");
    const JsonPlace node = what.cover.at(at++);
    const bool is_cut = node.size() > 0 && node.at(std::size_t(0)).value().is_string();
    const std::size_t members = is_cut ? 2 : what.leaf_size;
    if (node.size() != members) node.fail("must have " + std::to_string(members) + " members");
    if (!is_cut) return leaf(node);
    const std::string name = node.at(std::size_t(0)).text();
    for (std::size_t k = 0; k < box.size(); ++k) {
      if (what.domain.variables[k].name != name) continue;
      const double cut = node.at(1).number();
      const Bounds whole = box[k];
      if (!(whole.lo < cut && cut < whole.hi)) return bad("a cut is outside its box");
      box[k] = {whole.lo, cut};
      if (!visit(depth + 1)) return false;
      box[k] = {cut, whole.hi};
      if (!visit(depth + 1)) return false;
      box[k] = whole;
      return true;
    }
    return bad("a cut of " + name + ", which is not a variable of the domain");
  }
};

}  // namespace

Walked walk(const WalkedCover& what, long& leaves) {
  Walk w{what};
  for (const Variable& v : what.domain.variables) w.box.push_back({v.low, v.high});
  if (w.visit(0) && w.at != what.cover.size()) w.bad("the cover continues after its last leaf");
  leaves += w.leaves;
  return std::move(w.found);
}

std::string other_domain(const Domain& domain, const JsonPlace& row) {
  const std::string fault = "states a different domain";
  const JsonPlace stated = row.at("domain");
  if (!stated.value().is_object()) stated.fail("must be an object");
  if (stated.value().size() != domain.variables.size()) return fault;
  for (const Variable& v : domain.variables) {
    if (!stated.has(v.name)) return fault;
    const JsonPlace range = stated.at(v.name);
    if (range.size() != 2 || range.at(std::size_t(0)).number() != v.low || range.at(1).number() != v.high)
      return fault;
  }
  return "";
}

}  // namespace brdf::prove
