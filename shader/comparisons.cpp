#include "shader/comparisons.h"

#include <cmath>
#include <utility>
#include <vector>

#include "shader/program/operations.h"

namespace brdf::shader {
namespace {

// The surplus of a comparison of two numbers.
double surplus_of(Operation::Compares compares, double a, double b) {
  switch (compares) {
    case Operation::Compares::equal:
      return -std::abs(a - b);
    case Operation::Compares::not_equal:
      return std::abs(a - b);
    default:
      return b - a;
  }
}

}  // namespace

void for_each_comparison(const Function& f, std::span<const double> values, const Vec3<double>& wi,
                         const Vec3<double>& wo, const std::function<void(const MetComparison&)>& look) {
  const Program& program = f.program<double>();
  Runner<double, 1> runner(f);
  runner.set_values(f, std::vector<double>(values.begin(), values.end()));
  runner.set_directions(f, runner.lanes_of(wi), runner.lanes_of(wo));
  Bank<double, 1>& bank = runner.bank();
  const auto number = [&](std::uint32_t slot) { return *bank.number(slot); };
  std::vector<std::pair<const Step*, MetComparison>> met;           // of the running stretch
  std::vector<std::uint32_t> before(program.stretches.size() + 1);  // comparisons' numbers of each stretch
  for (std::size_t k = 0; k < program.stretches.size(); ++k)
    before[k + 1] = before[k] + 2 * std::uint32_t(program.stretches[k].steps.size());
  const auto add = [&](const Step& step, std::uint32_t second, bool holds, double surplus) {
    met.emplace_back(&step, MetComparison{second, step.line, holds, surplus});
  };
  run_watched<double>(
      program, bank,
      [&](const Step& s) {
        const Operation& o = operation(s.op);
        if (o.compares != Operation::Compares::no)
          return add(s, 0, *bank.integer(s.r) != 0, surplus_of(o.compares, number(s.a), number(s.b)));
        if (s.r == s.a || s.r == s.b || s.r == s.c) return;  // the operands are no longer known
        if (s.op == Op::min || s.op == Op::max || s.op == Op::step || s.op == Op::smoothstep ||
            s.op == Op::clamp) {
          // x against an edge, and for a second edge once more
          const double x = number(s.op == Op::step ? s.b : s.op == Op::smoothstep ? s.c : s.a);
          const double edge = number(s.op == Op::step || s.op == Op::smoothstep ? s.a : s.b);
          add(s, 0, x >= edge, x - edge);
          if (s.op == Op::clamp || s.op == Op::smoothstep) {
            const double upper = number(s.op == Op::clamp ? s.c : s.b);
            add(s, 1, x >= upper, x - upper);
          }
        }
      },
      kMostStepsRun,
      [&](const Stretch& stretch) {
        const std::uint32_t first = before[std::size_t(&stretch - program.stretches.data())];
        for (auto& [step, comparison] : met) {
          comparison.number += first + 2 * std::uint32_t(step - stretch.steps.data());
          look(comparison);
        }
        met.clear();
      });
}

}  // namespace brdf::shader
