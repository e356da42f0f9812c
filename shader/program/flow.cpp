#include "shader/program/flow.h"

namespace brdf::shader {
namespace {

int count_of_next(const Stretch& s) {
  return s.end == End::stop ? 0 : s.end == End::branch ? 2 : 1;
}

// For each stretch the stretches through which all its paths to an end of the program lead.
std::vector<Stretches> postdominators(const Program& p) {
  const std::size_t count = p.stretches.size();
  std::vector<Stretches> out(count, Stretches(count, true));
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = count; k-- > 0;) {
      const Stretch& s = p.stretches[k];
      Stretches of(count, s.end != End::stop);
      for (int j = 0; j < count_of_next(s); ++j) of.keep(out[s.next[j]]);
      of.add(k);
      if (of == out[k]) continue;
      out[k] = of;
      changed = true;
    }
  }
  return out;
}

}  // namespace

std::vector<Stretches> dominators(const Program& p) {
  const std::size_t count = p.stretches.size();
  std::vector<Stretches> out(count, Stretches(count, true));
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<Stretches> of(count, Stretches(count, true));
    of[0] = Stretches(count, false);
    for (std::size_t k = 0; k < count; ++k)
      for (int j = 0; j < count_of_next(p.stretches[k]); ++j) of[p.stretches[k].next[j]].keep(out[k]);
    for (std::size_t k = 0; k < count; ++k) {
      of[k].add(k);
      changed = changed || !(of[k] == out[k]);
    }
    out = std::move(of);
  }
  return out;
}

std::vector<std::vector<std::uint32_t>> controlled_stretches(const Program& p) {
  const std::vector<Stretches> after = postdominators(p);
  std::vector<std::vector<std::uint32_t>> out(p.stretches.size());
  for (std::size_t k = 0; k < p.stretches.size(); ++k) {
    const Stretch& branch = p.stretches[k];
    if (branch.end != End::branch) continue;
    Stretches seen(p.stretches.size(), false);
    std::vector<std::uint32_t> open(branch.next, branch.next + 2);
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      const bool meets = at != k && after[k].has(at);
      if (meets || seen.has(at)) continue;
      seen.add(at);
      out[k].push_back(at);
      const Stretch& s = p.stretches[at];
      for (int j = 0; j < count_of_next(s); ++j) open.push_back(s.next[j]);
    }
  }
  return out;
}

}  // namespace brdf::shader
