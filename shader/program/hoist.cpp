#include "shader/program/hoist.h"

#include <limits>

#include "shader/program/flow.h"
#include "shader/program/operations.h"

namespace brdf::shader {
namespace {

bool reads_any(const Step& step, const SlotSet& slots) {
  bool any = false;
  for_each_read(step, [&](bool integer, std::uint32_t slot) { any = any || slots.of(integer)[slot]; });
  return any;
}

// The step that writes a slot.
struct Writing {
  static constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t stretch = kNever, step = 0;
  bool only = true;  // the slot has no other value before or after it
};

class Writings {
 public:
  explicit Writings(const Program& p) : numbers_(p.numbers), integers_(p.integers) {
    for (const Input& input : p.inputs)
      for (const std::uint32_t slot : input.slots) of(input.integer, slot).only = false;
    for (std::uint32_t k = 0; k < p.stretches.size(); ++k)
      for (std::uint32_t at = 0; at < p.stretches[k].steps.size(); ++at) {
        const Step& step = p.stretches[k].steps[at];
        const Operation& o = operation(step.op);
        for (std::uint32_t j = 0; j < o.slots_written(step); ++j) {
          Writing& writing = of(o.writes_integer(), step.r + j);
          writing = {k, at, writing.only && writing.stretch == Writing::kNever && !o.stores()};
        }
      }
  }
  Writing& of(bool integer, std::uint32_t slot) { return integer ? integers_[slot] : numbers_[slot]; }

 private:
  std::vector<Writing> numbers_, integers_;
};

// Removes `only` from slots that a step may read before their step has run.
void require_written_first(const Program& p, Writings& writings) {
  const std::vector<Stretches> before = dominators(p);
  for (std::uint32_t k = 0; k < p.stretches.size(); ++k) {
    const Stretch& stretch = p.stretches[k];
    const auto read = [&](bool integer, std::uint32_t slot, std::uint32_t at) {
      Writing& writing = writings.of(integer, slot);
      if (writing.stretch == Writing::kNever) return;
      if (writing.stretch == k ? writing.step >= at : !before[k].has(writing.stretch)) writing.only = false;
    };
    const auto end = std::uint32_t(stretch.steps.size());
    for (std::uint32_t at = 0; at < end; ++at)
      for_each_read(stretch.steps[at], [&](bool integer, std::uint32_t slot) { read(integer, slot, at); });
    if (stretch.end == End::branch) read(true, stretch.condition, end);
    if (stretch.end == End::stop)
      for (const std::uint32_t slot : p.results) read(false, slot, end);
  }
}

}  // namespace

void add_computed(const Program& program, SlotSet& slots, bool integers_too) {
  for (bool more = true; more;) {
    more = false;
    for (const Stretch& stretch : program.stretches)
      for (const Step& step : stretch.steps) {
        const Operation& o = operation(step.op);
        if ((o.writes_integer() && !integers_too) || !reads_any(step, slots)) continue;
        std::vector<bool>& written = slots.of(o.writes_integer());
        for (std::uint32_t k = 0; k < o.slots_written(step); ++k)
          if (!written[step.r + k]) written[step.r + k] = more = true;
      }
  }
}

Hoisted hoist(const Program& program, const SlotSet& inputs) {
  Hoisted out{{}, program};
  constexpr std::size_t kMostStretches = std::size_t(1) << 12;
  if (program.stretches.size() > kMostStretches) return out;
  Writings writings(program);
  require_written_first(program, writings);
  SlotSet changes(program);
  for (const bool integer : {false, true})
    for (std::uint32_t slot = 0; slot < changes.of(integer).size(); ++slot)
      changes.of(integer)[slot] =
          writings.of(integer, slot).stretch != Writing::kNever || inputs.of(integer)[slot];
  for (Stretch& stretch : out.rest.stretches)
    std::erase_if(stretch.steps, [&](const Step& step) {
      const bool integer = operation(step.op).writes_integer();
      if (!writings.of(integer, step.r).only || reads_any(step, changes)) return false;
      changes.of(integer)[step.r] = false;
      out.once.push_back(step);
      return true;
    });
  return out;
}

}  // namespace brdf::shader
