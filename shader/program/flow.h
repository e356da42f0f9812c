// Follows facts about values forward through a program, over all paths, until they no longer change.
#pragma once

#include <cstdint>
#include <vector>

#include "shader/program/operations.h"
#include "shader/program/program.h"

namespace brdf::shader {

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

// Returns, for each stretch, the stretches through which all paths from the start lead to it, and itself.
std::vector<Stretches> dominators(const Program& program);

// Returns, for each stretch that ends with a branch, the stretches that run on some path from the branch to
// the point where all its paths meet again; empty for other stretches. Values written there depend on the
// condition.
std::vector<std::vector<std::uint32_t>> controlled_stretches(const Program& program);

// Calls pass(k) for each stretch k that a path has reached, until no call sets `changed`. begins[k] is empty
// before a path reaches stretch k. Returns false if a call returns false, or if the program is too large.
template <class State, class Pass>
bool until_unchanged(const std::vector<State>& begins, bool& changed, Pass&& pass) {
  constexpr std::size_t kMost = std::size_t(1) << 24, kMostStretches = std::size_t(1) << 14;
  if (begins[0].size() * begins.size() > kMost || begins.size() > kMostStretches) return false;
  do {
    changed = false;
    for (std::size_t k = 0; k < begins.size(); ++k)
      if (!begins[k].empty() && !pass(k)) return false;
  } while (changed);
  return true;
}

// A Domain has a type Value, for which Value{} means that no path has reached the slot yet, and
//   Value join(const Value&, const Value&)                  what holds after either of two paths
//   Value step(const Step&, const Operation&, const Value*) the result, from the values of the operands
//   Value element(const Value& elements, const Value& index)  one of the elements, and the index
//   bool branch(const Value& condition)                     false ends the analysis without a result
//   Value controlled(const Value& written, const Value& condition)
template <class Domain>
class Flow {
 public:
  using Value = typename Domain::Value;

  Flow(const Program& program, Domain& domain)
      : p_(program),
        domain_(domain),
        begins_(program.stretches.size()),
        control_(program.stretches.size()),
        results_(program.results.size()) {
    begins_[0].assign(std::size_t(p_.numbers) + p_.integers, Value{});
  }

  // The fact about a slot before the program runs.
  Value& start(bool integer, std::uint32_t slot) { return at(begins_[0], integer, slot); }

  // Returns false if the domain refuses a branch, or if the program is too large to be followed.
  bool run() {
    return until_unchanged(begins_, changed_, [&](std::size_t k) { return pass(k); });
  }
  // What holds of each result at every end of the program.
  const std::vector<Value>& results() const { return results_; }

 private:
  using State = std::vector<Value>;

  Value& at(State& s, bool integer, std::uint32_t slot) const {
    return s[integer ? p_.numbers + slot : slot];
  }

  bool pass(std::size_t which) {
    State s = begins_[which];
    const Stretch& stretch = p_.stretches[which];
    for (const Step& step : stretch.steps) follow(s, step, control_[which]);
    if (stretch.end == End::branch) {
      const Value condition = at(s, true, stretch.condition);
      if (!domain_.branch(condition)) return false;
      if (regions_.empty()) regions_ = controlled_stretches(p_);
      for (const std::uint32_t k : regions_[which]) grow(control_[k], condition);
    }
    if (stretch.end == End::stop) {
      for (std::size_t k = 0; k < results_.size(); ++k) grow(results_[k], at(s, false, p_.results[k]));
      return true;
    }
    for (int k = 0; k < (stretch.end == End::branch ? 2 : 1); ++k) {
      State& to = begins_[stretch.next[k]];
      if (to.empty()) to.assign(s.size(), Value{}), changed_ = true;
      for (std::size_t j = 0; j < to.size(); ++j) grow(to[j], s[j]);
    }
    return true;
  }
  void grow(Value& to, const Value& from) {
    if (Value both = domain_.join(to, from); !(both == to)) to = both, changed_ = true;
  }

  void follow(State& s, const Step& x, const Value& control) {
    const Operation& o = operation(x.op);
    const std::uint32_t slots[] = {x.a, x.b, x.c};
    if (o.loads() || o.stores()) return indexed(s, x, o, control);
    Value operands[3]{};
    for (int k = 0; k < o.count(); ++k) operands[k] = at(s, o.reads_integer(k), slots[k]);
    at(s, o.writes_integer(), x.r) = domain_.controlled(domain_.step(x, o, operands), control);
  }
  // The elements of an array are treated as one value.
  void indexed(State& s, const Step& x, const Operation& o, const Value& control) {
    const std::uint32_t from = o.loads() ? x.a : x.r;
    const bool integer = o.loads() ? o.reads_integer(0) : o.writes_integer();
    Value all{};
    for (std::uint32_t k = 0; k < x.c; ++k) all = domain_.join(all, at(s, integer, from + k));
    if (o.stores()) all = domain_.join(all, at(s, o.reads_integer(0), x.a));
    all = domain_.controlled(domain_.element(all, at(s, true, x.b)), control);
    if (o.loads()) {
      at(s, o.writes_integer(), x.r) = all;
      return;
    }
    for (std::uint32_t k = 0; k < x.c; ++k) {
      Value& element = at(s, integer, from + k);
      element = domain_.join(element, all);
    }
  }

  const Program& p_;
  Domain& domain_;
  std::vector<State> begins_;
  State control_, results_;
  std::vector<std::vector<std::uint32_t>> regions_;
  bool changed_ = false;
};

}  // namespace brdf::shader
