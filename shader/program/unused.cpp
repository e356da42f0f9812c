// Finds the operations that a program's results need.

#include "io/files/error.h"
#include "shader/program/lower.h"
#include "shader/program/operations.h"

namespace brdf::shader {
namespace {

// Slots that are read later: numbers, then integers.
class Live {
 public:
  explicit Live(const Program& program)
      : numbers_(program.numbers), bits_(program.numbers + program.integers) {}
  bool has(bool integer, std::uint32_t slot) const { return bits_[index(integer, slot)]; }
  void add(bool integer, std::uint32_t slot) { bits_[index(integer, slot)] = true; }
  void remove(bool integer, std::uint32_t slot) { bits_[index(integer, slot)] = false; }
  // Returns whether a slot was added.
  bool merge(const Live& other) {
    bool more = false;
    for (std::size_t k = 0; k < bits_.size(); ++k)
      if (other.bits_[k] && !bits_[k]) bits_[k] = more = true;
    return more;
  }

 private:
  std::size_t index(bool integer, std::uint32_t slot) const { return integer ? numbers_ + slot : slot; }
  std::size_t numbers_;
  std::vector<bool> bits_;
};

// Goes backward over a stretch and calls keep(k, needed) for each step.
template <class Keep>
void backward(const Stretch& stretch, Live& live, Keep&& keep) {
  if (stretch.end == End::branch) live.add(true, stretch.condition);
  for (std::size_t k = stretch.steps.size(); k-- > 0;) {
    const Step& step = stretch.steps[k];
    const Operation& o = operation(step.op);
    bool needed = false;
    for (std::uint32_t j = 0; j < o.slots_written(step) && !needed; ++j)
      needed = live.has(o.writes_integer(), step.r + j);
    keep(k, needed);
    if (!needed) continue;
    if (!o.stores()) live.remove(o.writes_integer(), step.r);
    for_each_read(step, [&](bool integer, std::uint32_t slot) { live.add(integer, slot); });
  }
}

}  // namespace

void check_slots(const Program& p) {
  const auto check = [&](bool integer, std::uint64_t slot) {
    if (slot >= (integer ? p.integers : p.numbers)) throw InputError("SPIR-V: a value has two types");
  };
  for (const Stretch& s : p.stretches) {
    if (s.end == End::branch) check(true, s.condition);
    for (const std::uint32_t next : s.next)
      if (s.end != End::stop && next >= p.stretches.size())
        throw InputError("SPIR-V: a branch leads nowhere");
    for (const Step& step : s.steps) {
      const Operation& o = operation(step.op);
      const std::uint32_t slots[] = {step.a, step.b, step.c};
      check(o.writes_integer(), step.r);
      for (int j = 0; j < o.count(); ++j) check(o.reads_integer(j), slots[j]);
      if (o.loads()) check(o.reads_integer(0), std::uint64_t(step.a) + step.c - 1);
      if (o.stores()) check(o.writes_integer(), std::uint64_t(step.r) + step.c - 1);
      if ((o.loads() || o.stores()) && step.c == 0) throw InputError("SPIR-V: an index is out of range");
    }
  }
}

void remove_unused(Program& program) {
  check_slots(program);
  const std::size_t count = program.stretches.size();
  constexpr std::size_t kMostBits = 1u << 28;
  if (count * (program.numbers + program.integers) > kMostBits) return;
  std::vector<Live> at_begin(count, Live(program));
  const auto at_end = [&](std::size_t k) {
    Live live(program);
    const Stretch& s = program.stretches[k];
    if (s.end == End::stop)
      for (const std::uint32_t slot : program.results) live.add(false, slot);
    if (s.end != End::stop) live.merge(at_begin[s.next[0]]);
    if (s.end == End::branch) live.merge(at_begin[s.next[1]]);
    return live;
  };
  for (bool more = true; more;) {
    more = false;
    for (std::size_t k = count; k-- > 0;) {
      Live live = at_end(k);
      backward(program.stretches[k], live, [](std::size_t, bool) {});
      more = at_begin[k].merge(live) || more;
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    Stretch& stretch = program.stretches[k];
    std::vector<bool> needed(stretch.steps.size());
    Live live = at_end(k);
    backward(stretch, live, [&](std::size_t step, bool is) { needed[step] = is; });
    std::size_t left = 0;
    for (std::size_t step = 0; step < needed.size(); ++step)
      if (needed[step]) stretch.steps[left++] = stretch.steps[step];
    stretch.steps.resize(left);
  }
}

}  // namespace brdf::shader
