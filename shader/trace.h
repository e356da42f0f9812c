// Runs one pair of directions step by step and records the operands and the result of each step.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "shader/function.h"
#include "shader/program/operations.h"

namespace brdf::shader {

// One executed step: its operands, and the entry that made each operand (-1: an input or a constant).
struct Entry {
  const Step* step;
  double result;
  double operand[3];
  int from[3];
};

// A comparison, or another step from numbers to an integer.
struct Decision {
  const Step* step;
  double operand[2];
  std::uint32_t result;
};

struct Trace {
  std::vector<Entry> entries = {};
  std::vector<Decision> decisions = {};
  int last = -1;  // the entry that made the result; -1: an input or a constant
  double result = 0;
};

// Returns the trace of one run in the scalar T, for one component of the result. Throws EndlessLoop.
template <class T>
Trace traced(const Function& f, std::span<const double> values, const Vec3<double>& wi,
             const Vec3<double>& wo, std::size_t component) {
  const Program& program = f.template program<T>();
  std::vector<T> rounded;
  for (const double v : values) rounded.push_back(Functions<T>::number(v));
  const auto convert = [](const Vec3<double>& w) { return Vec3<T>{T(w.x), T(w.y), T(w.z)}; };
  Runner<T, 1> runner(f);
  runner.set_values(f, rounded);
  runner.set_directions(f, runner.lanes_of(convert(wi)), runner.lanes_of(convert(wo)));
  Bank<T, 1>& bank = runner.bank();
  std::vector<int> writer(program.numbers, -1);
  // Values before the step that is executed, because a step may overwrite its own operand.
  std::vector<double> before(program.numbers);
  for (std::uint32_t slot = 0; slot < program.numbers; ++slot)
    before[slot] = Functions<T>::value(*bank.number(slot));
  Trace trace;
  constexpr std::size_t kMostEntries = 1u << 20;
  run_watched<T>(program, bank, [&](const Step& step) {
    const Operation& o = operation(step.op);
    const std::uint32_t slots[] = {step.a, step.b, step.c};
    Entry e{&step, 0, {NAN, NAN, NAN}, {-1, -1, -1}};
    for (int k = 0; k < o.count(); ++k) {
      if (o.reads_integer(k)) continue;
      std::uint32_t slot = slots[k];
      if (o.loads()) slot += std::min(*bank.integer(step.b), step.c - 1);
      e.operand[k] = before[slot];
      e.from[k] = writer[slot];
    }
    if (o.writes_integer()) {
      if (o.count() > 0 && !o.reads_integer(0) && trace.decisions.size() < kMostEntries)
        trace.decisions.push_back({&step, {e.operand[0], e.operand[1]}, *bank.integer(step.r)});
      return;
    }
    std::uint32_t r = step.r;
    if (o.stores()) r += std::min(*bank.integer(step.b), step.c - 1);
    e.result = before[r] = Functions<T>::value(*bank.number(r));
    if (step.op == Op::select) {  // only the operand that was selected
      const bool yes = *bank.integer(step.a) != 0;
      e.operand[0] = e.operand[yes ? 1 : 2];
      e.from[0] = e.from[yes ? 1 : 2];
      e.operand[1] = e.operand[2] = NAN;
      e.from[1] = e.from[2] = -1;
    }
    if (trace.entries.size() >= kMostEntries) return;
    trace.entries.push_back(e);
    writer[r] = int(trace.entries.size()) - 1;
  });
  const std::uint32_t slot = program.results[std::min(component, program.results.size() - 1)];
  trace.last = writer[slot];
  trace.result = before[slot];
  return trace;
}

}  // namespace brdf::shader
