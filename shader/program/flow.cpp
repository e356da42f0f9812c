#include "shader/program/flow.h"

namespace brdf::shader {
namespace {

// A set of stretches, as bits.
class Stretches {
 public:
  Stretches(std::size_t count, bool all) : words_((count + 63) / 64, all ? ~std::uint64_t(0) : 0) {}
  bool has(std::size_t k) const { return words_[k / 64] >> (k % 64) & 1; }
  void add(std::size_t k) { words_[k / 64] |= std::uint64_t(1) << (k % 64); }
  void keep(const Stretches& other) {
    for (std::size_t k = 0; k < words_.size(); ++k) words_[k] &= other.words_[k];
  }
  friend bool operator==(const Stretches&, const Stretches&) = default;

 private:
  std::vector<std::uint64_t> words_;
};

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
