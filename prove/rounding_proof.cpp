#include "prove/rounding_proof.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "io/files/numbers.h"

namespace brdf::prove {
namespace {

constexpr long kLeaves = 64;  // if more are needed, nothing is shown

// Returns the worse of the results of two boxes for one lobe.
LobeRounding worse(const LobeRounding& a, const LobeRounding& b) {
  return {std::max(a.beside, b.beside), std::max(a.error, b.error), std::max(a.underflow, b.underflow),
          std::max(a.peak, b.peak)};
}

// Walks the leaves of a cover and calls visit(box) for each.
template <class Visit>
void for_each_leaf(const Cover& cover, std::size_t& at, Box& box, const Visit& visit) {
  const Cover::Node& node = cover.nodes[at++];
  if (node.variable < 0) return visit(box);
  const std::size_t k = std::size_t(node.variable);
  const Bounds whole = box[k];
  box[k] = {whole.lo, node.cut};
  for_each_leaf(cover, at, box, visit);
  box[k] = {node.cut, whole.hi};
  for_each_leaf(cover, at, box, visit);
  box[k] = whole;
}

// Starts with a cover in which `error` is known everywhere. Lowers the limit of the error as long as the
// boxes suffice, and returns the last cover.
Cover smallest(const Proof& p, const std::function<Bounds(const Box&)>& error, const SearchOptions& search) {
  const auto at_most = [&](double most) {
    return cover(
        *p.domain, error, [&](Bounds b) { return settles(p.claim.property, b, 0) && b.hi <= most; }, search);
  };
  Cover found = at_most(HUGE_VAL);
  while (found.open == 0 && found.range.hi > 0) {
    Cover finer = at_most(found.range.hi * 0.8);
    if (finer.open > 0) break;
    found = std::move(finer);
  }
  return found;
}

// Prefers a cover with errors relative to the lobes themselves, if there is one.
Cover smallest(const Proof& p, const SearchOptions& search) {
  const auto error = [&](const Box& box) { return enclose(p.claim, box); };
  const auto relative = [&](const Box& box) {
    for (const LobeRounding& lobe : rounding_of(p.claim.form, p.claim.precision, box))
      if (lobe.beside != LobeRounding::Beside::value) return Bounds{0, HUGE_VAL};
    return error(box);
  };
  Cover found = smallest(p, relative, search);
  return found.open == 0 ? found : smallest(p, error, search);
}

std::string in_words(const LobeRounding& lobe) {
  if (lobe.beside == LobeRounding::Beside::nothing) return "sampled";
  return io::short_number(lobe.error, 3) +
         (lobe.beside == LobeRounding::Beside::value ? " relative" : " of its peak");
}
std::string in_words(const std::vector<LobeRounding>& lobes) {
  std::string words = lobes.size() == 1 ? "the error is " : "the lobes' errors are ";
  for (std::size_t k = 0; k < lobes.size(); ++k)
    words += (k == 0 ? "" : ", ") +
             std::string(lobes[k].beside == LobeRounding::Beside::nothing ? "" : "at most ") +
             in_words(lobes[k]);
  return words;
}

}  // namespace

void prove_rounding(Proof& p, const SearchOptions& search) {
  SearchOptions few = search;
  few.leaves = std::min(few.leaves, kLeaves);
  p.arithmetic = arithmetic_of(p.claim);
  p.cover = smallest(p, few);
  Box box = whole(*p.domain);
  std::size_t at = 0;
  for_each_leaf(p.cover, at, box, [&](const Box& leaf) {
    const auto lobes = rounding_of(p.claim.form, p.claim.precision, leaf);
    if (p.lobes.empty()) p.lobes = lobes;
    for (std::size_t k = 0; k < lobes.size(); ++k) p.lobes[k] = worse(p.lobes[k], lobes[k]);
  });
  p.low = 0;
  p.high = p.cover.range.hi;
  p.verdict = p.cover.open == 0 ? Verdict::proved : Verdict::no_method;
  p.statement = in_words(p.lobes);
}

}  // namespace brdf::prove
